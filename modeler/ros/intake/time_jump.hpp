// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace ribbon_mapper {

/// What the modeler does when simulated time is set back: a bag loops, a simulation starts again.
enum class OnTimeJump {
  reset,  ///< empties the model
  stop,   ///< keeps the model and takes no more lines until ~reset
  go_on,  ///< keeps the model and takes lines again once they are later than its newest
};

/// Returns the choice that a parameter names. Throws std::invalid_argument that lists the three
/// names.
inline OnTimeJump on_time_jump_from(const std::string& name) {
  if (name == "reset") return OnTimeJump::reset;
  if (name == "stop") return OnTimeJump::stop;
  if (name == "continue") return OnTimeJump::go_on;
  throw std::invalid_argument("parameter on_time_jump is '" + name +
                              "', allowed are reset, stop and continue");
}

/// Returns the consequence of a choice, for the log.
inline const char* what_happens_on(OnTimeJump choice) {
  switch (choice) {
    case OnTimeJump::reset:
      return "the model is empty again (~on_time_jump reset)";
    case OnTimeJump::stop:
      return "the model stays and takes no lines until ~reset";
    case OnTimeJump::go_on:
      return "the model stays; lines older than its newest are dropped";
  }
  return "";
}

}  // namespace ribbon_mapper
