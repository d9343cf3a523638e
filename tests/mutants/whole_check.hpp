// SPDX-License-Identifier: BSD-3-Clause
/// `scarp check` on any text, in this process: from the reader to the last line it prints.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace scarp {

struct CheckedText {
  std::string fault;    ///< what is wrong with the program; empty: nothing
  std::string message;  ///< what the program said of the scene, if it refused it
  std::string scene;    ///< the text that was checked: with a coarser spacing where that is needed
  bool accepted = false;
  double time_step = 0.0;  ///< of the trial [s]
};

/// Checks a text as a file in `folder`, with at most about `particles` particles: the spacing of a
/// scene with more is made larger, unless it has so many that it must be refused. Crashes are the
/// caller's to notice; what the program prints and writes is judged.
CheckedText check_whole(std::string_view text, const std::filesystem::path& folder,
                        double particles);

}  // namespace scarp
