// Command lines, lessons and decks with the shadow map's former switches draw what the techniques draw that they have become.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

class OldSpellingCommandTest : public CommandTest {
protected:
    /// The pixels of a capture, and what was said of it.
    std::vector<std::uint8_t> pixels(std::vector<std::string> words, std::string& said) const {
        words.insert(words.begin(), {"capture", "box.json", "--size", "64x48"});
        words.insert(words.end(), {"-o", "out.png"});
        said = succeed(words).err;
        return decoded(fileContent(folder.path() / "out.png")).image.rgba;
    }
};

TEST_F(OldSpellingCommandTest, CapturesAreTheSame) {
    const struct {
        std::vector<std::string> before, now;
        std::string note;
    } cases[] = {
        {{"-t", "shadow-map", "--set", "shadow-map.exact=true", "--set", "shadow-map.resolution=64", "--set",
          "shadow-map.filter=vsm"},
         {"-t", "shadow-map-exact", "--set", "shadow-map-exact.resolution=64"},
         "exact=true is now the technique shadow-map-exact"},
        {{"-t", "shadow-map", "--set", "shadow-map.alias-free=true", "--stage", "eye-samples"},
         {"-t", "shadow-map-alias-free", "--stage", "eye-samples"},
         "alias-free=true is now the technique shadow-map-alias-free"},
        {{"-t", "shadow-map", "--stage", "traced"},
         {"-t", "shadow-map-exact", "--stage", "traced"},
         "stage traced is now one of the technique shadow-map-exact"},
        {{"-t", "shadow-map", "--set", "shadow-map.exact=false", "--set", "shadow-map.alias-free=false"},
         {"-t", "shadow-map"},
         ""},
    };
    std::set<std::vector<std::uint8_t>> different;
    for (const auto& one : cases) {
        std::string noteBefore, noteNow;
        const std::vector<std::uint8_t> now = pixels(one.now, noteNow);
        EXPECT_EQ(pixels(one.before, noteBefore), now) << one.now[1];
        // Of pictures this small legends are left out, which is said as well.
        EXPECT_EQ(noteNow.find(" is now "), std::string::npos) << noteNow;
        EXPECT_EQ(noteBefore, (one.note.empty() ? "" : "shadowlab: note: shadow-map's " + one.note + "\n") + noteNow);
        different.insert(now);
    }
    EXPECT_EQ(different.size(), 4u) << "pictures that are all alike prove nothing";
}

/// Only of the state that the switch is on in; what both have in common goes to both.
TEST_F(OldSpellingCommandTest, ALessonStillHolds) {
    folder.write("old.json", R"({"title": "Old", "scene": "box.json", "slots": [{"technique": "shadow-map"}],
        "set": ["shadow-map.resolution=64", "shadow-map.filter=hard", "shadow-map.bias-mode=none"],
        "before": {"set": ["shadow-map.exact=false"]}, "after": {"set": ["shadow-map.exact=true"]},
        "happens": "Stripes.", "mends": "Rays.", "look": [{"box": [0.1, 0.1, 0.2, 0.2], "label": "here"}],
        "expect": [{"quantity": "falseShadow", "before": {"atLeast": 5}, "after": {"atMost": 0}}]})");
    const ProgramResult result = succeed({"lesson", "old.json"});
    EXPECT_NE(result.out.find("as expected"), std::string::npos) << result.out;
    EXPECT_EQ(result.err, "shadowlab: note: shadow-map's exact=true is now the technique shadow-map-exact\n");
}

TEST_F(OldSpellingCommandTest, MeasureAndProbeKnowItToo) {
    const ProgramResult measured = succeed(
        {"measure", "box.json", "--size", "64x48", "-t", "shadow-map", "--set", "shadow-map.exact=true", "--json"});
    EXPECT_NE(measured.out.find("\"shadow-map-exact\""), std::string::npos) << measured.out;
    const ProgramResult probed = succeed({"probe", "box.json", "--size", "64x48", "--pixel", "32,24", "-t",
                                          "shadow-map", "--set", "shadow-map.alias-free=true"});
    EXPECT_NE(probed.out.find("shadow-map-alias-free"), std::string::npos) << probed.out;
}

} // namespace
} // namespace shadowlab::testing
