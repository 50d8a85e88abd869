// Outputs appear whole or not at all: every way a write can fail leaves the old file, no temporary and a useful line.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/output_file.h"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>

#include "techniques/foundation/base/error.h"

namespace shadowlab::image {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "shadowlab_output_XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder = pattern;
    }
    void TearDown() override {
        fs::permissions(folder, fs::perms::owner_all);
        fs::remove_all(folder);
    }
    [[nodiscard]] std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    static std::string contents(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    static mode_t modeOf(const fs::path& file) {
        struct stat status {};
        EXPECT_EQ(::stat(file.c_str(), &status), 0);
        return status.st_mode & 0777;
    }
    fs::path folder;
};

/// Runs `action`, expects Error (cannotWrite), returns its message.
std::string failureOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::cannotWrite);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("; "), std::string::npos) << "no remedy in: " << error.what();
        return error.what();
    }
    ADD_FAILURE() << "no error";
    return "";
}

void expectHas(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << '"' << text << "\" lacks \"" << part << '"';
}

TEST_F(OutputFileTest, WritesTheBytesAndNothingElse) {
    writeWhole(folder / "a.png", std::string_view("one\0two", 7));
    EXPECT_EQ(contents(folder / "a.png"), std::string("one\0two", 7));
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, NewFilesObeyTheUmask) {
    const mode_t old = ::umask(027);
    writeWhole(folder / "a", "x");
    ::umask(old);
    EXPECT_EQ(modeOf(folder / "a"), 0640u);
}

TEST_F(OutputFileTest, ReplacingKeepsTheModeBits) {
    writeWhole(folder / "a", "old");
    for (const mode_t mode : {0600u, 0664u, 0755u}) {
        ASSERT_EQ(::chmod((folder / "a").c_str(), mode), 0);
        writeWhole(folder / "a", "new");
        EXPECT_EQ(modeOf(folder / "a"), mode);
    }
    EXPECT_EQ(contents(folder / "a"), "new");
}

TEST_F(OutputFileTest, WithoutCommitTheOldFileStaysAndTheTemporaryGoes) {
    writeWhole(folder / "a", "old");
    {
        OutputFile file(folder / "a");
        file.write("half");
        EXPECT_EQ(entries(), 2u);
        EXPECT_EQ(contents(folder / "a"), "old");
    }
    EXPECT_EQ(contents(folder / "a"), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, TwoWritersOfOneNameDoNotDisturbEachOther) {
    OutputFile first(folder / "a"), second(folder / "a");
    first.write("first");
    second.write("second");
    first.commit();
    EXPECT_EQ(contents(folder / "a"), "first");
    second.commit();
    EXPECT_EQ(contents(folder / "a"), "second");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, FullDeviceIsReported) {
    const auto text = failureOf([] { writeWhole("/dev/full", "x"); });
    expectHas(text, "/dev/full: no space left on device");
}

TEST_F(OutputFileTest, NullDeviceTakesEverything) {
    EXPECT_NO_THROW(writeWhole("/dev/null", "x"));
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(OutputFileTest, FolderInsteadOfFile) {
    expectHas(failureOf([&] { probeWritable(folder); }), "is a folder");
    expectHas(failureOf([&] { probeWritable(folder / ""); }), "is a folder");
    expectHas(failureOf([] { probeWritable(""); }), "no name");
}

TEST_F(OutputFileTest, MissingFolderIsNamedWithItsMend) {
    const auto text = failureOf([&] { probeWritable(folder / "no/such/a.png"); });
    expectHas(text, "mkdir -p " + (folder / "no/such").string());
    writeWhole(folder / "file", "x");
    expectHas(failureOf([&] { probeWritable(folder / "file/a.png"); }), "is a file and not a folder");
}

TEST_F(OutputFileTest, NameLengths) {
    EXPECT_NO_THROW(
        writeWhole(folder / std::string(255, 'a'), "x")); // the temporary's name has to be shorter than ours
    EXPECT_EQ(entries(), 1u);
    expectHas(failureOf([&] { probeWritable(folder / std::string(256, 'a')); }), "file name too long");
}

TEST_F(OutputFileTest, ProbeLeavesNoTrace) {
    writeWhole(folder / "old", "old");
    probeWritable(folder / "old");
    probeWritable(folder / "new");
    EXPECT_EQ(entries(), 1u);
    EXPECT_EQ(contents(folder / "old"), "old");
}

TEST_F(OutputFileTest, LinksKeepPointing) {
    writeWhole(folder / "real", "old");
    fs::create_symlink("real", folder / "link");
    fs::create_symlink("later", folder / "dangling");
    writeWhole(folder / "link", "new");
    writeWhole(folder / "dangling", "made");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(contents(folder / "real"), "new");
    EXPECT_EQ(contents(folder / "later"), "made");
    fs::create_symlink("circle", folder / "circle");
    expectHas(failureOf([&] { probeWritable(folder / "circle"); }), "in a circle");
}

/// In a child process, because neither a file size limit nor the user can be changed back. Returns its exit status.
int inChild(const std::function<int()>& action) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(action());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(OutputFileTest, FileSizeLimitKeepsTheOldFile) {
    writeWhole(folder / "a", "old");
    const int status = inChild([&] {
        std::signal(SIGXFSZ, SIG_IGN); // as the program's main does
        const rlimit limit{4096, 4096};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            writeWhole(folder / "a", std::string(10'000, 'x'));
        } catch (const Error& error) {
            const std::string text = error.what();
            return text.find("file too large") != std::string::npos &&
                           text.find("old file is kept") != std::string::npos
                       ? 4
                       : 1;
        }
        return 0;
    });
    EXPECT_EQ(status, 4);
    EXPECT_EQ(contents(folder / "a"), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, PermissionsAreRespected) {
    writeWhole(folder / "kept", "old");
    fs::permissions(folder / "kept", fs::perms::owner_read);
    fs::create_directory(folder / "closed");
    fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
    const uid_t nobody = 65534; // root may write everywhere, so a child gives that up first
    if (::geteuid() == 0) {
        for (const char* name : {"", "kept", "closed"})
            ASSERT_EQ(::chown((folder / name).c_str(), nobody, nobody), 0);
    }
    const int status = inChild([&] {
        if (::geteuid() == 0 && ::setuid(nobody) != 0) return 100;
        int failures = 0;
        for (const char* name : {"kept", "closed/a"}) {
            try {
                probeWritable(folder / name);
            } catch (const Error& error) {
                failures += error.status() == ExitStatus::cannotWrite;
            }
        }
        return failures;
    });
    EXPECT_EQ(status, 2);
    EXPECT_EQ(contents(folder / "kept"), "old");
}

TEST_F(OutputFileTest, KilledRunIsSweptAndLivingOnesAreNot) {
    // A kill leaves its temporary behind, unlocked.
    inChild([&] {
        auto* leaked = new OutputFile(folder / "a");
        leaked->write("half");
        return 0; // _exit runs no destructor
    });
    EXPECT_EQ(entries(), 1u);
    OutputFile living(folder / "a");
    EXPECT_EQ(entries(), 1u) << "the stray is gone, the new temporary is there";
    writeWhole(folder / "a", "whole");
    EXPECT_EQ(entries(), 2u) << "the living temporary was swept";
    living.commit();
    EXPECT_EQ(contents(folder / "a"), "");
}

TEST_F(OutputFileTest, SignalHandlerRemovesWhatIsUnderWay) {
    inChild([&] {
        auto* leaked = new OutputFile(folder / "a");
        leaked->write("half");
        removeTemporariesNow();
        return 0;
    });
    EXPECT_EQ(entries(), 0u);
}

TEST_F(OutputFileTest, StandardOutputIsAppendedTo) {
    const fs::path log = folder / "log";
    writeWhole(log, "before ");
    inChild([&] {
        if (!std::freopen(log.c_str(), "a", stdout)) return 1;
        probeWritable("/dev/stdout");
        writeWhole("/dev/stdout", "after");
        return 0;
    });
    EXPECT_EQ(contents(log), "before after");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, ClosedPipeIsReported) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    ::close(ends[0]);
    const auto old = std::signal(SIGPIPE, SIG_IGN);
    expectHas(failureOf([&] { writeWhole("/dev/fd/" + std::to_string(ends[1]), "x"); }), "closed the pipe");
    std::signal(SIGPIPE, old);
    ::close(ends[1]);
}

} // namespace
} // namespace shadowlab::image
