// `shadowlab slides` after a run that did not come to its end: what stands is kept, what has changed since is drawn again, and the
// result is that of a run which nobody disturbed.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include "tests/cli/command_fixture.h"

namespace shadowlab {
namespace {

/// A run that is stopped at the last of its slides: a folder has the name of that slide's file.
class StoppedSlidesTest : public testing::CommandTest {
protected:
    using Words = std::vector<std::string>;
    StoppedSlidesTest() {
        folder.write("deck.json", deck());
        EXPECT_EQ(slides().status, 0);
        undisturbed_ = listing();
        EXPECT_GE(undisturbed_.size(), 12u);
        std::filesystem::remove_all(folder.path() / "out");
        stop();
    }
    [[nodiscard]] static std::string deck(const std::string& firstTitle = "A box") {
        return R"({"title": "A deck", "scene": "box.json", "slides": [
  {"name": "box", "title": ")" +
               firstTitle + R"(", "slots": [{"technique": "shadow-map"}], "alt": "A box."},
  {"name": "words", "title": "Words", "text": ["No picture."], "formulas": ["\\frac{1}{2}"]},
  {"name": "last", "title": "Last", "slots": [{"technique": "unshadowed"}], "alt": "A box."}]})";
    }
    [[nodiscard]] testing::ProgramResult slides(const Words& more = {"--size", "640x360", "--supersample", "1"}) const {
        Words words{"slides", "deck.json", "-o", "out"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words, {.environment = environment_});
    }
    void stop() const {
        std::filesystem::remove(last());
        std::filesystem::create_directories(last());
        ASSERT_EQ(slides().status, 4);
        std::filesystem::remove(last());
    }
    [[nodiscard]] std::string content(const std::string& name) const {
        return testing::fileContent(folder.path() / "out" / name);
    }
    [[nodiscard]] std::filesystem::path last() const { return folder.path() / "out/deck-03-last.png"; }

    [[nodiscard]] std::filesystem::path list() const { return folder.path() / "out/deck.unfinished.json"; }

    /// Files are replaced by others when they are written: what has kept its inode has not been drawn again.
    [[nodiscard]] std::uint64_t inodeOf(const std::string& name) const {
        struct stat status {};
        return ::stat((folder.path() / "out" / name).c_str(), &status) == 0 ? status.st_ino : 0;
    }

    /// Goes on, and says how many slides were kept.
    template <typename... Options>
    [[nodiscard]] int keptSlides(const Options&... options) const {
        const std::uint64_t box = inodeOf("deck-01-box.png"), words = inodeOf("deck-02-words.png");
        EXPECT_NE(box, 0u);
        EXPECT_NE(words, 0u);
        const testing::ProgramResult result = slides(options...);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_FALSE(std::filesystem::exists(list()));
        const int kept = (inodeOf("deck-01-box.png") == box) + (inodeOf("deck-02-words.png") == words);
        const std::string said = std::to_string(kept) + " of 3 slides were there already";
        EXPECT_EQ(result.err.find(said) != std::string::npos, kept > 0) << result.err;
        return kept;
    }

    Listing undisturbed_;
    std::map<std::string, std::string> environment_;
};

TEST_F(StoppedSlidesTest, TheSameCommandGoesOnAndMakesTheSame) {
    EXPECT_FALSE(content("deck.unfinished.json").empty());
    EXPECT_EQ(keptSlides(), 2);
    EXPECT_EQ(listing(), undisturbed_);
}

TEST_F(StoppedSlidesTest, ARunThatCameToItsEndIsMadeAnew) {
    EXPECT_EQ(keptSlides(), 2);
    EXPECT_EQ(keptSlides(), 0);
}

TEST_F(StoppedSlidesTest, WhatHasChangedIsDrawnAgain) {
    const std::string scene = testing::fileContent(folder.path() / "box.json");
    EXPECT_EQ(keptSlides(Words{"--size", "640x400", "--supersample", "1"}), 0);
    stop();
    EXPECT_EQ(keptSlides(Words{"--size", "640x360", "--supersample", "2"}), 0);
    stop();
    folder.write("deck.json", deck("Another title"));
    EXPECT_EQ(keptSlides(), 0) << "the deck";
    folder.write("deck.json", deck());
    stop();
    folder.write("box.json", scene + "// the same scene\n");
    EXPECT_EQ(keptSlides(), 2) << "the scene is the same";
    stop();
    folder.write("box.json", testing::sceneText(testing::kCamera, testing::kTwoLights,
                                                R"("objects": [{"shape": "quad", "size": [11, 12]}])"));
    EXPECT_EQ(keptSlides(), 1) << "words alone show no scene";
    folder.write("box.json", scene);
    static_cast<void>(slides());
    EXPECT_EQ(listing(), undisturbed_);
}

TEST_F(StoppedSlidesTest, AnEditedShaderDrawsSomethingElse) {
    const std::filesystem::path shaders = folder.path().string() + "-shaders";
    std::filesystem::copy(SHADOWLAB_SOURCE_DIR "/shaders", shaders, std::filesystem::copy_options::recursive);
    environment_ = {{"SHADOWLAB_SHADERS", shaders.string()}};
    EXPECT_EQ(keptSlides(), 2) << "the same shaders, from files";
    stop();
    std::ofstream(shaders / "shadow_map" / "lookup.glsl", std::ios::app) << "// edited\n";
    EXPECT_EQ(keptSlides(), 0);
    std::filesystem::remove_all(shaders);
}

TEST_F(StoppedSlidesTest, FilesThatAreNotAsTheyWereWrittenAreDrawnAgain) {
    for (const std::string name : {"deck-01-box.png", "pictures/deck-01-box.png"}) {
        folder.write("out/" + name, "");
        EXPECT_EQ(keptSlides(), 1) << name;
        EXPECT_EQ(listing(), undisturbed_) << name;
        stop();
        folder.write("out/" + name, content("pictures/deck-03-last.png"));
        EXPECT_EQ(keptSlides(), 1) << name;
        EXPECT_EQ(listing(), undisturbed_) << name;
        stop();
        std::filesystem::remove(folder.path() / "out" / name);
        EXPECT_EQ(slides().status, 0) << name << " is gone";
        EXPECT_EQ(listing(), undisturbed_) << name << " is gone";
        stop();
    }
}

TEST_F(StoppedSlidesTest, AShadersOwnFilesCountToo) {
    const std::filesystem::path shaders = folder.path().string() + "-shaders";
    std::filesystem::copy(SHADOWLAB_SOURCE_DIR "/shaders", shaders, std::filesystem::copy_options::recursive);
    std::ofstream(shaders / "shadow_map" / "lookup.glsl", std::ios::app) << "#include \"own.glsl\"\n";
    std::ofstream(shaders / "own.glsl") << "// first\n";
    environment_ = {{"SHADOWLAB_SHADERS", shaders.string()}};
    stop();
    EXPECT_EQ(keptSlides(), 2);
    stop();
    std::ofstream(shaders / "own.glsl") << "// second\n";
    EXPECT_EQ(keptSlides(), 0);
    std::filesystem::remove_all(shaders);
}

TEST_F(StoppedSlidesTest, WhatIsNotOursIsLeftAsItIs) {
    const std::string ours = content("deck.unfinished.json");
    folder.write("elsewhere.json", ours);
    const auto expectLeft = [&](const std::string& what) {
        const testing::ProgramResult result = slides();
        EXPECT_EQ(result.status, 0) << what << ": " << result.err;
        EXPECT_NE(result.err.find("deck.unfinished.json: is none of ours"), std::string::npos) << what << result.err;
        EXPECT_FALSE(content("deck-03-last.png").empty()) << what;
        EXPECT_TRUE(std::filesystem::exists(std::filesystem::symlink_status(list()))) << what;
        stop();
    };
    for (const std::string text : {"", "{}", "[]", "{\"shadowlab\": 1, \"slides\": {}}", "my own notes"}) {
        folder.write("out/deck.unfinished.json", text);
        expectLeft("'" + text + "'");
        EXPECT_EQ(content("deck.unfinished.json"), text);
    }
    std::filesystem::remove(list());
    std::filesystem::create_symlink(folder.path() / "elsewhere.json", list());
    expectLeft("a link");
    EXPECT_EQ(testing::fileContent(folder.path() / "elsewhere.json"), ours);
    std::filesystem::remove(list());
    std::filesystem::create_directory(list());
    expectLeft("a folder");
    std::filesystem::remove(list());
    EXPECT_EQ(::mkfifo(list().c_str(), 0600), 0);
    expectLeft("a FIFO");
}

TEST_F(StoppedSlidesTest, OneSlideAloneLeavesTheOthersStanding) {
    EXPECT_EQ(slides({"--size", "640x360", "--supersample", "1", "--only", "words"}).status, 0);
    EXPECT_NE(content("deck.unfinished.json").find("01-box"), std::string::npos);
    EXPECT_EQ(content("deck.unfinished.json").find("02-words"), std::string::npos);
    EXPECT_EQ(keptSlides(), 1);
    EXPECT_EQ(listing(), undisturbed_);
}

TEST_F(StoppedSlidesTest, NothingIsLeftOfSlidesThatTheDeckHadBefore) {
    std::string renamed = deck();
    renamed.replace(renamed.find("\"words\""), 7, "\"others\"");
    folder.write("deck.json", renamed);
    EXPECT_EQ(slides().status, 0);
    EXPECT_FALSE(std::filesystem::exists(list()));
}

TEST_F(StoppedSlidesTest, DecksOfOneNameAreRefused) {
    folder.write("other/deck.json", deck());
    expectRefused({"slides", "deck.json", "other/deck.json", "-o", "both"}, 2, {"'deck'"});
    expectRefused({"slides", "deck.json", "deck.json", "-o", "both"}, 2, {"'deck'"});
}

} // namespace
} // namespace shadowlab
