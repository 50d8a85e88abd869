// SPDX-License-Identifier: MIT
#include "techniques/foundation/params/param_json.h"

#include "techniques/foundation/base/error.h"

namespace shadowlab::params {

nlohmann::ordered_json toJson(const ParamList& list) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const Param& param : list) {
        switch (param.kind) {
        case Kind::boolean: object[param.id] = param.get() != 0; break;
        case Kind::integer: object[param.id] = static_cast<int>(param.get()); break;
        case Kind::real: object[param.id] = param.get(); break;
        case Kind::choice: object[param.id] = valueText(param); break;
        }
    }
    return object;
}

void setFromJson(ParamList& list, const nlohmann::ordered_json& object, std::string_view owner) {
    if (!object.is_object())
        throw Error(ExitStatus::usage,
                    "parameters of '" + std::string(owner) + "' are not an object; write {\"name\": value}");
    std::vector<double> before;
    for (const Param& param : list)
        before.push_back(param.get());
    try {
        for (const auto& [id, value] : object.items())
            // setFromText reads the text of numbers, booleans and choices, and refuses everything else.
            setFromText(find(list, id, owner), value.is_string() ? value.get<std::string>() : value.dump(), owner);
    } catch (const Error&) {
        for (std::size_t i = 0; i < list.size(); ++i)
            list[i].set(before[i]);
        throw;
    }
}

} // namespace shadowlab::params
