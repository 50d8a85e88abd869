// Looking a material's name up by what is left of it without quotes and comments.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/material_names.h"

#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/load/unusual_characters.h"

namespace shadowlab::scene {

namespace {

enum Form : std::size_t { whole, noComment, noClearComment };

/// `#25` is rather a number than a comment; `# blue` is one.
std::string_view withoutClearComment(std::string_view name) {
    const std::string_view rest = withoutComment(name);
    const std::size_t sign = name.find('#', rest.size());
    const bool isClear =
        sign != std::string_view::npos && (sign + 1 == name.size() || name[sign + 1] == ' ' || name[sign + 1] == '\t');
    return isClear ? rest : name;
}

std::string keyOf(std::string_view name, Form form) {
    return std::string(unquoted(form == whole       ? name
                                : form == noComment ? withoutComment(name)
                                                    : withoutClearComment(name)));
}

} // namespace

MaterialNames::MaterialNames(const std::unordered_set<std::string>& defined) {
    const auto enter = [](Names& names, const std::string& key, const std::string& name) {
        const auto [entry, isNew] = names.try_emplace(key, name);
        if (!isNew) entry->second.reset();
    };
    for (const std::string& name : defined)
        for (const Form form : {whole, noComment, noClearComment}) {
            const std::string key = keyOf(name, form);
            enter(byKey_[form], key, name);
            enter(byKeyInSmallLetters_[form], inSmallLetters(key), name);
        }
}

std::optional<std::string> MaterialNames::meant(const std::string& used) const {
    constexpr std::array<std::array<Form, 2>, 4> kForms{
        // of `used`, of the defined name
        {{whole, whole}, {noComment, whole}, {whole, noComment}, {noClearComment, noClearComment}}};
    if (used.starts_with("# ") || used == "#" || keyOf(used, whole).empty()) return "";
    for (const bool inSmall : {false, true})
        for (const auto& [ofUsed, ofDefined] : kForms) {
            const Names& names = (inSmall ? byKeyInSmallLetters_ : byKey_)[ofDefined];
            const std::string key = keyOf(used, ofUsed);
            if (const auto found = names.find(inSmall ? inSmallLetters(key) : key); found != names.end())
                return found->second;
        }
    return std::nullopt;
}

} // namespace shadowlab::scene
