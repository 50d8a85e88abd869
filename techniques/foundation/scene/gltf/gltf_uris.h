// How a glTF file names the bytes of its buffers and images: the path of a file beside it, or the bytes themselves in base64.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace shadowlab::scene {

/// Does the URI begin with a scheme, such as http: or data:? (C:\ is a drive.)
bool hasScheme(std::string_view uri);

inline bool isDataUri(std::string_view uri) { return uri.starts_with("data:"); }

/// The bytes of a data: URI; nothing where they are not in base64, or not well-formed. Blanks and line breaks are skipped.
std::optional<std::string> bytesOfDataUri(std::string_view uri);

/// The path that a URI stands for: %20 becomes a blank. What is no escape stays as it is.
std::string percentDecoded(std::string_view uri);

/// The other way round: all but letters, digits and -._~/ are escaped.
std::string percentEncoded(std::string_view path);

} // namespace shadowlab::scene
