// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/mutation/mutator.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <utility>

#include "test/io/environment_number.hpp"

namespace ribbon_mapper::mutation {
namespace {

constexpr unsigned kMostSeconds = 10;
constexpr long kMostKilobytes = 2L << 20;
constexpr std::size_t kLongestMessage = 2000;

int number_of_mutations() { return environment_number("RIBBON_MAPPER_MUTATIONS", 300); }

long peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// Returns what is wrong with how a text was read, or nothing.
std::string defect_of(const std::string& text,
                      const std::function<void(const std::string&)>& read) {
  try {
    read(text);
  } catch (const std::exception& error) {
    const std::string message = error.what();
    if (message.empty()) return "is refused without a word";
    if (message.size() > kLongestMessage) return "is refused in too many words: " + message;
  } catch (...) {
    return "throws what is no std::exception";
  }
  return {};
}

}  // namespace

Mutator::Mutator(std::vector<std::string> samples, std::vector<std::string> words, unsigned seed)
    : samples_(std::move(samples)), words_(std::move(words)), random_(seed) {
  for (const char* word : {"0", "-1", "1e300", "-1e19", "nan", "-inf", "99999999999999999999",
                           "0,5", "", "\xff\xfe"}) {
    words_.emplace_back(word);
  }
}

std::string Mutator::next() {
  std::string text = samples_[below(samples_.size())];
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(text);
  return text;
}

void Mutator::change(std::string& text) {
  if (text.empty()) text = any_word();
  const std::size_t at = below(text.size() + 1);
  const std::size_t length = below(std::min<std::size_t>(text.size() - at, 64) + 1);
  const auto is_number = [](unsigned char c) { return std::isdigit(c) || c == '.' || c == '-'; };
  switch (below(8)) {
    case 0:  // a byte
      if (at < text.size()) text[at] = static_cast<char>(below(256));
      break;
    case 1:  // the next number
    case 2: {
      const auto begin =
          std::find_if(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), is_number);
      const auto end = std::find_if_not(begin, text.end(), is_number);
      text.replace(begin, end, any_word());
      break;
    }
    case 3:
      text.insert(at, any_word());
      break;
    case 4:
      text.erase(at, length);
      break;
    case 5:
      text.insert(at, text.substr(at, length));
      break;
    case 6:
      text.insert(below(text.size() + 1), text.substr(at, length));
      break;
    default:  // a cut file, less often than the rest
      if (below(4) == 0)
        text.resize(at);
      else
        text.replace(at, length, any_word());
  }
}

std::string Mutator::any_word() { return words_[below(words_.size())]; }

std::size_t Mutator::below(std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
}

void expect_read_or_refused(Mutator mutator, const std::string& name,
                            const std::function<void(const std::string&)>& read) {
  const auto path = std::filesystem::temp_directory_path() / ("mutation." + name);
  for (int i = 0; i < number_of_mutations(); ++i) {
    const std::string text = mutator.next();
    std::ofstream(path, std::ios::binary) << text;
    alarm(kMostSeconds);
    const std::string defect = defect_of(text, read);
    alarm(0);
    ASSERT_EQ("", defect) << "mutation " << i << " in " << path;
    ASSERT_LT(peak_kilobytes(), kMostKilobytes) << "mutation " << i << " in " << path;
  }
  std::filesystem::remove(path);
}

}  // namespace ribbon_mapper::mutation
