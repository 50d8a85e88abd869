// Words for lights that any command line, address and file system takes as they are. A scene may call its lights what it likes ("Key & Fill #1",
// "Sun/1", "--help"); POV-Ray takes no such name of a file, and in an address signs mean other things.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/light.h"

namespace shadowlab::foreign {

/// For each light a word of ASCII letters, digits, - and _, at most 64 of them, that does not begin with -. A name that is such a word stays as it is; of others
/// every run of other signs becomes one -, and none at either end. No two words are the same, whether or not capitals count: else the number of the light is added ("sun-2").
std::vector<std::string> lightWords(const std::vector<scene::Light>& lights);

/// " --light NAME" for Shadowlab's own commands, which know the light's name alone; with = where the name could be taken for an option.
std::string lightOption(const std::string& name);

} // namespace shadowlab::foreign
