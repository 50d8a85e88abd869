// docs/relations.md says what holds which relation: every test it names is there, and every relation is on it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/relations/relation.h"

namespace shadowlab::relations {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// "Suite.Name" of every test in the source.
std::set<std::string> allTests() {
    const std::regex test(R"(\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(SHADOWLAB_SOURCE_DIR "/tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = read(entry.path());
        for (auto it = std::sregex_iterator(text.begin(), text.end(), test); it != std::sregex_iterator(); ++it)
            names.insert((*it)[1].str() + "." + (*it)[2].str());
    }
    return names;
}

/// What stands in backquotes on the page, and looks like that.
std::set<std::string> named(const std::string& pattern) {
    const std::string page = read(SHADOWLAB_SOURCE_DIR "/docs/relations.md");
    const std::regex words("`(" + pattern + ")`");
    std::set<std::string> found;
    for (auto it = std::sregex_iterator(page.begin(), page.end(), words); it != std::sregex_iterator(); ++it)
        found.insert((*it)[1].str());
    return found;
}

TEST(RelationsPage, NamesTestsThatThereAre) {
    const std::set<std::string> tests = allTests(), onPage = named("[A-Z]\\w*\\.[A-Z]\\w*");
    EXPECT_GE(onPage.size(), 50u);
    for (const std::string& name : onPage)
        EXPECT_TRUE(tests.contains(name)) << "docs/relations.md names " << name << ", which no file in tests/ has";
}

TEST(RelationsPage, NamesEveryRelationAndNoOther) {
    std::set<std::string> ids;
    for (const Relation& relation : allRelations())
        EXPECT_TRUE(ids.emplace(relation.id).second) << relation.id << " is there twice";
    EXPECT_EQ(named("[a-z]+(?:-[a-z]+)+|moved"), ids);
}

} // namespace
} // namespace shadowlab::relations
