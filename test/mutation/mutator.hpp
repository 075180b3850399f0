// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace ribbon_mapper::mutation {

/// Damages sample files as cut transfers, typing errors and hostile tools do. The sequence depends
/// on the samples and the seed only.
class Mutator {
 public:
  /// Keeps the samples, at least one. `words` are inserted at times: keys, tags, extreme values.
  Mutator(std::vector<std::string> samples, std::vector<std::string> words, unsigned seed = 1);

  /// Returns one of the samples after one to four changes: bytes, numbers, words or whole parts
  /// are replaced, repeated, moved or cut.
  std::string next();

 private:
  void change(std::string& text);
  std::string any_word();
  std::size_t below(std::size_t count);

  std::vector<std::string> samples_, words_;
  std::mt19937 random_;
};

/// Reads mutations and expects each to be read or refused by a std::exception with a text of 1 to
/// 2000 characters. Ends the process where a reading takes 10 s. Fails where the process needs 2
/// GB. Their number is that of the environment's RIBBON_MAPPER_MUTATIONS (default 300). The
/// mutation being read lies in `mutation.<name>` of the temporary folder, to be looked at after a
/// crash.
void expect_read_or_refused(Mutator mutator, const std::string& name,
                            const std::function<void(const std::string&)>& read);

}  // namespace ribbon_mapper::mutation
