// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace ribbon_mapper {

/// What to do when simulated time goes back: a bag loops, a simulation is started again.
enum class OnTimeJump {
  reset,  ///< the model starts anew
  stop,   ///< the model stays and takes no more lines until ~reset
  go_on,  ///< the model stays; lines are taken again once they are later than its newest
};

/// Throws std::invalid_argument naming the three choices.
inline OnTimeJump on_time_jump_from(const std::string& name) {
  if (name == "reset") return OnTimeJump::reset;
  if (name == "stop") return OnTimeJump::stop;
  if (name == "continue") return OnTimeJump::go_on;
  throw std::invalid_argument("parameter on_time_jump is '" + name +
                              "', allowed are reset, stop and continue");
}

inline const char* what_happens_on(OnTimeJump choice) {
  switch (choice) {
    case OnTimeJump::reset:
      return "the model starts anew (~on_time_jump reset)";
    case OnTimeJump::stop:
      return "the model stays and takes no lines until ~reset";
    case OnTimeJump::go_on:
      return "the model stays; lines older than its newest are dropped";
  }
  return "";
}

}  // namespace ribbon_mapper
