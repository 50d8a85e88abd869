// Names of which no two are the same: "leaf", "leaf 2", "leaf 3".
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <set>
#include <string>

namespace shadowlab::scene {

class UniqueNames {
public:
    std::string unique(const std::string& wish) {
        std::string name = wish;
        for (int& number = last_.try_emplace(wish, 1).first->second; !taken_.insert(name).second;)
            name = wish + " " + std::to_string(++number);
        return name;
    }

private:
    std::set<std::string> taken_;
    std::map<std::string, int> last_; ///< numbers given to a wish, so that a thousand equal ones are not tried from 2 on
};

} // namespace shadowlab::scene
