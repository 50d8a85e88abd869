// Names of materials that usemtl and newmtl write in two ways: with quotes, with a comment behind them, in letters of another case.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace shadowlab::scene {

/// Looks a name up among those that are defined. A name that is defined as it stands means just that, and is not to be asked for here: `#`
/// and quotes may be part of it ("Material #25").
class MaterialNames {
public:
    explicit MaterialNames(const std::unordered_set<std::string>& defined);

    /// The one defined name that is meant; nothing where none or several may be. In this order: without quotes; without a comment behind
    /// `used`, or behind the defined name; without comments behind both, where a blank follows each `#`; all this in letters of
    /// another case. The empty name, which stands for the default material, where `used` is quotes or a comment alone.
    [[nodiscard]] std::optional<std::string> meant(const std::string& used) const;

private:
    using Names = std::unordered_map<std::string, std::optional<std::string>>; ///< nothing where several have the key

    std::array<Names, 3> byKey_, byKeyInSmallLetters_; ///< whole, without a comment, without one that a blank follows
};

} // namespace shadowlab::scene
