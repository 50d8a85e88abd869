// The world around a capture fails: disks, folders, graphics, signals. One line, the documented status, nothing
// half-done.
// SPDX-License-Identifier: MIT
#include <grp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/cli/command_fixture.h"
#include "tests/support/osmesa.h"

namespace shadowlab::testing {
namespace {

using Words = std::vector<std::string>;

class FaultsTest : public CommandTest {
protected:
    static Words captureTo(const std::string& output, const Words& more = {}) {
        Words words = {"capture", "box.json", "-o", output, "--size", "32x24"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
};

/// Root may write everywhere: tests of permissions run as nobody.
void becomeNobody() {
    if (::geteuid() != 0) return;
    constexpr unsigned kNobody = 65534;
    if (::setgroups(0, nullptr) != 0 || ::setgid(kNobody) != 0 || ::setuid(kNobody) != 0) ::_exit(125);
}

// --- outputs

TEST_F(FaultsTest, FullDisk) {
    expectRefused(captureTo("/dev/full"), 4, {"/dev/full", "no space left on device"});
    expectRefused(captureTo("/dev/null", {"--stats", "/dev/full"}), 4, {"/dev/full"});
}

TEST_F(FaultsTest, FullDiskUnderEveryKindOfOutput) {
    const auto refused = [&](const Words& words) { expectRefused(words, 4, {"/dev/full", "no space left"}); };
    refused(captureTo("/dev/full", {"--stage", "visibility", "--light", "key"}));
    refused(captureTo("/dev/full", {"--frames", "2", "--orbit-light", "9", "--animate"}));
    refused({"lesson", "acne", "-o", "/dev/full"});
    const ProgramResult probed =
        run({"probe", "box.json", "--pixel", "16,15", "--size", "32x24", "--diagram", "/dev/full"});
    expectOneLine(probed, 4, {"/dev/full", "no space left"});
    for (const std::string words : {"list parameters", "measure box.json --size 32x24", "inspect box.json",
                                    "measure box.json --size 32x24 --json", "lesson acne"})
        expectOneLine(shell("\"$SHADOWLAB\" " + words + " >/dev/full"), 4, {"standard output", "no space left"});
}

TEST_F(FaultsTest, SmallestFileSizeUnderFoldersOfOutputs) {
    const ProgramSetting smallFiles{.inChild = [] {
        const rlimit limit{512, 512}; // bytes: less than the first of them, more than what is said of it
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }};
    for (const Words& words :
         {Words{"slides", "shadows", "--only", "shadows", "--size", "640x360", "-o", "out"},
          Words{"report", "box.json", "--quick", "-o", "out"}, Words{"new-technique", "my-own", "-o", "out"},
          Words{"pack", "still-life", "-o", "out"}, Words{"export", "still-life", "-o", "out", "--to", "mitsuba"}}) {
        const ProgramResult refused = run(words, smallFiles);
        expectOneLine(refused, 4, {"file too large"});
        EXPECT_EQ(refused.err.find(".tmp."), std::string::npos) << "names a place that is gone: " << refused.err;
        for (const auto& [name, content] : listing())
            EXPECT_TRUE(content.empty() || name == "box.json") << words[0] << " leaves " << name;
        std::filesystem::remove_all(folder.path() / "out");
    }
}

TEST_F(FaultsTest, MissingFolder) {
    expectRefused(captureTo("none/x.png"), 4, {"none/x.png", "the folder none does not exist", "mkdir -p none"});
    expectRefused(captureTo("x.png", {"--stats", "none/s.json"}), 4, {"none/s.json"});
}

TEST_F(FaultsTest, OutputIsAFolder) {
    std::filesystem::create_directories(folder.path() / "dir.png" / "inside");
    expectRefused(captureTo("dir.png"), 4, {"dir.png", "is a folder"});
    expectRefused(captureTo("dir.png/"), 4, {"dir.png/", "is a folder"});
    expectRefused(captureTo("box.json/x.png"), 4, {"a part of the path is a file"});
}

TEST_F(FaultsTest, NameTooLong) { expectRefused(captureTo(std::string(300, 'a') + ".png"), 4, {"file name too long"}); }

TEST_F(FaultsTest, ReadOnlyFolderAndFile) {
    namespace fs = std::filesystem;
    fs::create_directory(folder.path() / "locked");
    folder.write("kept.png", "old");
    fs::permissions(folder.path() / "kept.png", fs::perms(0444));
    fs::permissions(folder.path() / "locked", fs::perms(0555));
    fs::permissions(folder.path(), fs::perms(0777));
    fs::permissions(folder.path() / "box.json", fs::perms(0644));
    const ProgramSetting nobody{.inChild = becomeNobody};
    if (run({"--version"}, nobody).status != 0) GTEST_SKIP() << "this build cannot be run by another user";
    expectRefused(captureTo("locked/x.png"), 4, {"locked/x.png", "permission denied"}, nobody);
    expectRefused(captureTo("kept.png"), 4, {"kept.png", "read-only"}, nobody);
    fs::permissions(folder.path() / "box.json", fs::perms(0200));
    expectRefused(captureTo("x.png"), 3, {"box.json", "Permission denied"}, nobody);
}

TEST_F(FaultsTest, TheOldFileIsKeptOnFailureAndReplacedOnSuccess) {
    folder.write("x.png", "old");
    expectRefused(captureTo("x.png", {"--light", "none"}), 2, {"none"});
    expectRefused({"capture", "none.json", "-o", "x.png"}, 3, {"none.json"});
    const ProgramSetting smallFiles{.inChild = [] {
        const rlimit limit{512, 512}; // bytes: the picture is larger
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }};
    Words large = captureTo("x.png");
    large.back() = "300x200";
    expectRefused(large, 4, {"x.png", "file too large", "old file is kept"}, smallFiles);
    succeed(captureTo("x.png"));
    EXPECT_EQ(headerOf(fileContent(folder.path() / "x.png")).width, 32u);
    EXPECT_EQ(listing().size(), 2u);
}

TEST_F(FaultsTest, ClosedDescriptorsDoNotEndUpInTheFiles) {
    succeed(captureTo("x.png"));
    const std::string expected = fileContent(folder.path() / "x.png");
    const std::string line = "\"$SHADOWLAB\" capture box.json -o y.png --size 32x24 ";
    for (const std::string closed : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
        EXPECT_EQ(shell(line + closed).status, 0) << closed;
        EXPECT_EQ(fileContent(folder.path() / "y.png"), expected) << closed;
        std::filesystem::remove(folder.path() / "y.png");
    }
    expectOneLine(shell("\"$SHADOWLAB\" capture box.json -o /dev/stdout --size 32x24 >&-"), 4, {"/dev/stdout"});
    expectOneLine(shell("exec 3>&2; { sleep 0.3; \"$SHADOWLAB\" capture box.json -o /dev/stdout --size 32x24 2>&3; } | "
                        "true; exit 4"),
                  4, {"/dev/stdout", "closed the pipe"});
}

// --- graphics

TEST_F(FaultsTest, NoDisplay) {
    const ProgramSetting none{.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}};
    expectRefused(captureTo("x.png", {"--backend", "window"}), 5, {"no graphics context from window"}, none);
    expectRefused(captureTo("x.png", {"--backend", "window"}), 5, {"window"},
                  {.environment = {{"DISPLAY", ":987"}, {"WAYLAND_DISPLAY", ""}}});
    const Listing before = listing();
    EXPECT_EQ(run(captureTo("x.png"), none).status, 0);
    EXPECT_EQ(newSince(before), Words{"x.png"});
}

TEST_F(FaultsTest, DriverTooOld) {
    ProgramSetting old{.environment = {{"MESA_GL_VERSION_OVERRIDE", "2.1"}, {"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}};
    for (const std::string backend : {"auto", "egl", "osmesa"})
        if (backend != "osmesa" || !testing::mayLackOsmesa())
            expectRefused(captureTo("x.png", {"--backend", backend}), 5, {"3.3"}, old);
}

// --- signals

/// Waits, at most a minute, until `name` exists.
bool waitFor(const std::filesystem::path& name) {
    for (int i = 0; i < 6000 && !std::filesystem::exists(name); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return std::filesystem::exists(name);
}

/// Runs until `sign` is there, takes the folder "out" away, and looks at what is said.
class VanishingFolderTest : public FaultsTest {
protected:
    void expectNoticed(const Words& words, const std::string& sign) {
        std::filesystem::create_directory(folder.path() / "out");
        Words argv{SHADOWLAB_PROGRAM};
        argv.insert(argv.end(), words.begin(), words.end());
        RunningProgram program(argv, {.folder = folder.path()});
        ASSERT_TRUE(waitFor(folder.path() / "out" / sign));
        std::filesystem::rename(folder.path() / "out", folder.path() / "moved");
        expectOneLine(program.wait(), 4, {"out/", "does not exist"});
        EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
        std::filesystem::remove_all(folder.path() / "moved");
    }
};

TEST_F(VanishingFolderTest, IsNoticed) {
    expectNoticed({"capture", "box.json", "-o", "out/f_####.png", "--size", "160x120", "--frames", "100000"},
                  "f_0003.png");
    expectNoticed({"report", "box.json", "--size", "160x120", "-o", "out"}, "parts/box@key/unshadowed.json");
    expectNoticed({"slides", "shadows", "--size", "640x360", "-o", "out"}, "shadows-01-shadows.png");
}

class SignalTest : public FaultsTest, public ::testing::WithParamInterface<int> {};

TEST_P(SignalTest, AnEndedSequenceHasWholeFramesOnly) {
    std::signal(GetParam(), SIG_DFL); // also where these tests were started with nohup
    RunningProgram program({SHADOWLAB_PROGRAM, "capture", "box.json", "-o", "f_####.png", "--size", "160x120",
                            "--frames", "100000", "--orbit-light", "360", "--stats", "s.json"},
                           {.folder = folder.path()});
    ASSERT_TRUE(waitFor(folder.path() / "f_0003.png"));
    program.signal(GetParam());
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.status, 128 + GetParam()) << result.shown();
    EXPECT_EQ(result.out + result.err, "");
    int frames = 0;
    for (const auto& [name, content] : listing()) {
        if (name == "box.json") continue;
        EXPECT_EQ(name.substr(0, 2), "f_") << "left behind: " << name;
        EXPECT_EQ(decoded(content).image.width, 160);
        ++frames;
    }
    EXPECT_GE(frames, 3);
    EXPECT_LT(frames, 100000);
}
INSTANTIATE_TEST_SUITE_P(Signals, SignalTest, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& info) { return std::string(::sigabbrev_np(info.param)); });

TEST_F(FaultsTest, AKilledRunIsSweptUpByTheNext) {
    RunningProgram program(
        {SHADOWLAB_PROGRAM, "capture", "box.json", "-o", "f_####.png", "--size", "160x120", "--frames", "100000"},
        {.folder = folder.path()});
    ASSERT_TRUE(waitFor(folder.path() / "f_0002.png"));
    program.signal(SIGKILL);
    EXPECT_EQ(program.wait().status, 128 + SIGKILL);
    for (const auto& [name, content] : listing())
        if (name.starts_with("f_")) {
            EXPECT_EQ(decoded(content).image.width, 160) << name;
        }
    // What a run leaves that is killed between making its temporary and renaming it.
    folder.write(".x.png.tmp.1.0", "half");
    succeed(captureTo("x.png"));
    for (const auto& [name, content] : listing())
        EXPECT_FALSE(name.starts_with(".x.png")) << name;
}

} // namespace
} // namespace shadowlab::testing
