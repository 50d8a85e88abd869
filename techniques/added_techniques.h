// The registry, for those who add to it: techniques of plug-ins (plugin.h) come after ours.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/registry.h"
#include "techniques/source_text.h"

namespace shadowlab {

/// Adds those of a plug-in, which must outlive the program, as their texts do. To be called before anybody has asked for the list.
void addTechniques(std::string_view folder, std::span<const TechniqueInfo> infos);

/// Adds the sources of a plug-in that have anchors, whose texts must outlive the program.
void addSources(std::span<const EmbeddedSource> sources);

/// Ours, from the generated file.
std::vector<RegisteredTechnique> builtInTechniques();

} // namespace shadowlab
