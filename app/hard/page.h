// The hard cases as a page for a browser. It needs nothing else but the pictures beside it, and can be read without them.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/hard/results.h"

namespace shadowlab::hard {

std::string hardPage(const std::vector<CaseResult>& results, const std::string& renderer);

/// Its tables: each technique before each case's scene, and what switches a careless version on and who finds it out.
std::string matrixTable(const std::vector<CaseResult>& results);
std::string carelessTable(const std::vector<CaseResult>& results);

/// A link that opens the picture and its error map; just the text where there is none. `about`: what it shows, in words.
std::string pictureLink(const Pictures& pictures, const std::string& text, const std::string& about,
                        const std::string& facts);

/// A cell of a table; `kind` is its class.
std::string tableCell(const std::string& text, const std::string& kind = "");

extern const std::string_view kHardStyle, kHardScript;

} // namespace shadowlab::hard
