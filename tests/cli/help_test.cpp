// Help: fits a terminal, has examples that are right, and says what the man page and the docs say of exit statuses.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <regex>
#include <sstream>

#include "app/cli/command_line.h"
#include "app/cli/exit_statuses.h"
#include "app/cli/global_options.h"
#include "app/cli/text_table.h"
#include "techniques/foundation/base/error.h"
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

class HelpTest : public CommandTest {
protected:
    static std::vector<std::string> linesOf(const std::string& text) {
        std::vector<std::string> all;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            all.push_back(line);
        return all;
    }
    /// The names in the help's part `Commands`.
    [[nodiscard]] std::vector<std::string> commands() const {
        std::vector<std::string> names;
        bool isThere = false;
        for (const std::string& line : linesOf(succeed({"help"}).out)) {
            if (line == "Commands:") isThere = true;
            if (line.empty()) isThere = false;
            static const std::regex kName("  ([a-z-]+) .*");
            std::smatch found;
            if (isThere && std::regex_match(line, found, kName)) names.push_back(found[1]);
        }
        return names;
    }
};

TEST_F(HelpTest, FitsATerminalOf80Columns) {
    const std::vector<std::string> names = commands();
    ASSERT_GE(names.size(), 12u);
    std::size_t lines = 0;
    for (const std::string& name : names) {
        const std::string text = succeed({"help", name}).out;
        EXPECT_EQ(text, succeed({name, "--help"}).out);
        EXPECT_NE(text.find("\nUsage: shadowlab " + name), std::string::npos) << text;
        for (const std::string& line : linesOf(text)) {
            EXPECT_LE(line.size(), 80u) << name << ": " << line;
            EXPECT_FALSE(line.ends_with(' ')) << name << ": '" << line << "'";
            ++lines;
        }
    }
    for (const std::string& line : linesOf(succeed({"--help"}).out))
        EXPECT_LE(line.size(), 80u) << line;
    EXPECT_GE(lines, 250u);
    EXPECT_EQ(succeed({"help"}).out, succeed({"--help"}).out);
}

// Examples are parsed and checked as the program does it, short of doing the work.
TEST_F(HelpTest, EveryCommandHasExamplesThatAreRight) {
    int examples = 0;
    std::vector<std::string> names = commands();
    names.emplace_back(); // the program's own
    for (const std::string& name : names) {
        std::string text = name.empty() ? succeed({"help"}).out : succeed({"help", name}).out;
        text = std::regex_replace(text, std::regex(" \\\\\n +"), " ");
        const std::size_t begin = text.find("\nExamples:\n");
        ASSERT_NE(begin, std::string::npos) << name;
        int ofThis = 0;
        for (const std::string& line : linesOf(text.substr(begin + 11))) {
            std::istringstream words(line);
            std::vector<std::string> argv;
            for (std::string word; words >> word && word != "|";)
                argv.push_back(word);
            if (argv.empty() || argv.front() != "shadowlab") continue;
            const cli::TakenWords plugins = cli::takeWordsOf("--plugin", "FILE.so", argv);
            try {
                EXPECT_TRUE(cli::workFor(plugins.words, plugins.values)) << line;
            } catch (const Error& why) {
                ADD_FAILURE() << line << ": " << why.what();
            }
            ++ofThis;
        }
        EXPECT_GE(ofThis, 1) << name;
        examples += ofThis;
    }
    EXPECT_GE(examples, 35);
}

TEST_F(HelpTest, HelpIsACommand) {
    EXPECT_NE(succeed({"help", "capture"}).out.find("--layout LAYOUT"), std::string::npos);
    EXPECT_NE(succeed({"help", "help"}).out.find("shadowlab help [COMMAND]"), std::string::npos);
    expectRefused({"help", "captre"}, 2, {"no command 'captre'", "\"capture\""});
    expectRefused({"help", "capture", "measure"}, 2, {"'measure' is one argument too many"});
    expectRefused({"captre", "still-life"}, 2, {"'captre'", "\"capture\""});
}

TEST_F(HelpTest, ExitStatusesAreSaidTheSameEverywhere) {
    const auto squeezed = [](std::string text) {
        text = std::regex_replace(text, std::regex("\\\\-"), "-");
        return std::regex_replace(text, std::regex("\\s+"), " ");
    };
    const std::filesystem::path root = SHADOWLAB_SOURCE_DIR;
    const std::string help = squeezed(succeed({"help"}).out);
    const std::string man = squeezed(fileContent(root / "app/install/shadowlab.1"));
    const std::string docs = squeezed(fileContent(root / "docs/errors.md"));
    for (const auto& [status, meaning] : cli::kExitMeanings) {
        const std::string number(status), words(meaning);
        EXPECT_NE(help.find(" " + number + " " + words), std::string::npos) << number;
        EXPECT_NE(man.find(".B " + number + " " + words + " ."), std::string::npos) << number;
        EXPECT_NE(docs.find("| " + number + " | " + words + " |"), std::string::npos) << number;
    }
    EXPECT_GE(cli::kExitMeanings.size(), 9u);
    for (const std::string& name : commands())
        EXPECT_NE(man.find(".TP .B " + name + " "), std::string::npos) << name << " is not in the man page";
}

TEST_F(HelpTest, ABareListIsAnOverview) {
    const std::string text = succeed({"list"}).out;
    int lists = 0;
    for (const std::string& line : linesOf(text)) {
        static const std::regex kLine("([a-z]+)\t([0-9]+)\t.+");
        std::smatch found;
        ASSERT_TRUE(std::regex_match(line, found, kLine)) << line;
        EXPECT_EQ(linesOf(succeed({"list", found[1]}).out).size(), static_cast<std::size_t>(std::stoi(found[2])))
            << line;
        ++lists;
    }
    EXPECT_GE(lists, 13);
    const nlohmann::json json = nlohmann::json::parse(succeed({"list", "--json"}).out);
    EXPECT_EQ(json.at("lists").size(), static_cast<std::size_t>(lists));
    expectRefused({"list", "filters"}, 2, {"'filters'", "shadow-map.filter", "list parameters"});
    expectRefused({"list", "shadow-map"}, 2, {"'shadow-map'", "list techniques"});
    expectRefused({"list", "tecniques"}, 2, {"'tecniques'", "\"techniques\""});
}

TEST_F(HelpTest, APictureInAnotherFormatIsTold) {
    for (const char* name : {"x.jpg", "x.JPEG", "x.gif"}) {
        expectRefused({"capture", "box.json", "-o", name}, 2, {name, "write x.png"});
        expectRefused({"lesson", "acne", "-o", name}, 2, {name, "write x.png"});
        expectRefused({"probe", "box.json", "--pixel", "1,1", "--diagram", name}, 2, {name, "write x.png"});
    }
    expectRefused({"capture", "box.json", "-o", "shot.v2"}, 2, {"write shot.v2.png"});
    expectRefused({"capture", "box.json", "-o", "picture"}, 2, {"write picture.png"});
}

// In a list every column begins where its heading does; what is too long goes on below.
TEST_F(HelpTest, ListsOfATerminalAreAligned) {
    const cli::Rows rows{{"a", "the first thing that there is, in as many words as do not fit in one line of it", "1"},
                         {"long-name", "b", "22"}};
    const std::vector<std::string> lines = linesOf(cli::listed({"name", "what", "n"}, rows, 60));
    ASSERT_GE(lines.size(), 4u);
    const std::size_t what = lines.front().find("what"), n = lines.front().find(" n") + 1;
    for (const std::string& line : lines)
        EXPECT_LE(line.size(), 60u) << line;
    EXPECT_EQ(lines[1].find("the first"), what);
    EXPECT_EQ(lines[1].find('1'), n);
    EXPECT_EQ(lines[2].find_first_not_of(' '), what) << "the long text goes on in its column";
    EXPECT_EQ(lines.back().find('b'), what);
    EXPECT_EQ(lines.back().find("22"), n);
    // Columns that cannot stand side by side stand below one another, with their names.
    const std::string words(60, 'x');
    const std::string below = cli::listed({"name", "one", "two"}, {{"a", words, "b"}}, 40);
    EXPECT_EQ(below, "a\n    one:\n    " + words + "\n    two: b\n");
}

} // namespace
} // namespace shadowlab::testing
