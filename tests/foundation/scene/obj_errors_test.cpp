// What an OBJ file may not be. Every refusal names the file, the true line, and carries the right exit status.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>
#include <unistd.h>

#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"; // lines 1 to 3

struct BadObj {
    const char* name;
    std::string text;
    int line;
    const char* phrase;
    ExitStatus status = ExitStatus::badInput;
};
void PrintTo(const BadObj& bad, std::ostream* out) { *out << bad.name; }

class BadObjFiles : public testing::TestWithParam<BadObj> {};

TEST_P(BadObjFiles, AreRefusedWithLineAndReason) {
    const TempFolder folder;
    const auto file = folder.write("bad.obj", GetParam().text);
    const Error error = errorOf([&] { (void)loadObj(file, NormalMode::file, {}); });
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(file.string() + ":" + std::to_string(GetParam().line) + ": ")) << message;
    EXPECT_TRUE(contains(message, GetParam().phrase)) << message;
    EXPECT_TRUE(contains(message, "; ")) << "says what to do: " << message;
    EXPECT_FALSE(contains(message, "\n")) << message;
    EXPECT_EQ(error.status(), GetParam().status) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, BadObjFiles,
    testing::Values(
        BadObj{"IndexTooLarge", kThree + "f 1 2 9\n", 4, "vertex index 9, but the file has only 3 \"v\" lines"},
        BadObj{"IndexIntMax", kThree + "f 1 2 2147483647\n", 4, "vertex index 2147483647"},
        BadObj{"IndexWrapsInt32", kThree + "f 4294967297 2 3\n", 4, "vertex index 4294967297"},
        BadObj{"IndexOverflows", kThree + "f 1 2 99999999999999999999\n", 4, "is not a valid vertex index"},
        BadObj{"IndexBeyondAtoi", kThree + "f 1 2 99999999999\n", 4, "vertex index 99999999999"},
        BadObj{"NegativeOutOfRange", kThree + "f -1 -2 -9\n", 4, "vertex index -9, but only 3"},
        BadObj{"NegativeForward", "v 0 0 0\nf -1 -2 -3\nv 1 0 0\nv 0 1 0\n", 2,
               "vertex index -2, but only 1 \"v\" line"},
        BadObj{"NegativeMinimum", kThree + "f 1 2 -9223372036854775808\n", 4, "but only 3"},
        BadObj{"IndexZero", kThree + "f 0 1 2\n", 4, "vertex index 0; OBJ counts from 1"},
        BadObj{"NormalOutOfRange", kThree + "vn 0 0 1\nf 1//1 2//1 3//2\n", 5, "normal index 2"},
        BadObj{"TexcoordOutOfRange", kThree + "vt 0 0\nf 1/1 2/1 3/7\n", 5, "texture coordinate index 7"},
        BadObj{"FirstOfSeveralForward", "f 1 2 3\nf 1 2 8\nf 1 2 9\n" + kThree, 2, "vertex index 8"},
        BadObj{"IndexNotANumber", kThree + "f 1 2 x\n", 4, "\"x\" is not a valid vertex index"},
        BadObj{"IndexWithPoint", kThree + "f 1 2 3.5\n", 4, "\"3.5\" is not a valid"},
        BadObj{"IndexEmpty", kThree + "f 1 2 /3\n", 4, "is not a valid vertex index"},
        BadObj{"TooManySlashes", kThree + "vn 0 0 1\nf 1//1 2//1 3//1/1\n", 5, "is not a valid normal index"},
        BadObj{"TwoCorners", kThree + "f 1 2\n", 4, "a face needs at least 3"},
        BadObj{"NoCorners", kThree + "f\n", 4, "0 corners"},
        BadObj{"Nan", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", 2, "not a finite number"},
        BadObj{"Inf", "v 0 0 0\nv 0 -inf 0\nv 0 1 0\nf 1 2 3\n", 2, "not a finite number"},
        BadObj{"TooLargeForDouble", "v 0 0 1e400\n", 1, "not a finite number"},
        BadObj{"BeyondTheLimit", "v 0 0 0\nv 1e30 0 0\nv 0 1 0\nf 1 2 3\n", 2, "rescale the model"},
        BadObj{"DecimalComma", "v 0 0 0\nv 1,5 0 0\nv 0 1 0\nf 1 2 3\n", 2, "write a decimal point"},
        BadObj{"TwoCoordinates", "v 0 0 0\nv 1 0\n", 2, "the vertex has 2 numbers"},
        BadObj{"NoCoordinates", "v\n", 1, "the vertex has 0 numbers"},
        BadObj{"FiveNumbers", "v 1 2 3 4 5\n", 1, "the vertex has 5 numbers"},
        BadObj{"Junk", "v abc 0 0\n", 1, "\"abc\" is not a number"},
        BadObj{"TrailingJunk", "v 1x 0 0\n", 1, "\"1x\" is not a number"},
        BadObj{"HexNumber", "v 0x10 0 0\n", 1, "is not a number"},
        BadObj{"ShortNormal", kThree + "vn 0 1\nf 1 2 3\n", 4, "the normal has 2 numbers"},
        BadObj{"NoTexcoord", kThree + "vt\nf 1 2 3\n", 4, "the texture coordinate has 0 numbers; write u v"},
        BadObj{"LongTexcoord", kThree + "vt 0 0 0 0\nf 1 2 3\n", 4, "the texture coordinate has 4 numbers"},
        BadObj{"JunkTexcoord", kThree + "vt 0 b\nf 1 2 3\n", 4, "\"b\" is not a number"},
        BadObj{"JunkNormal", kThree + "vn a b c\nf 1 2 3\n", 4, "\"a\" is not a number"},
        BadObj{"NulByte", kThree + std::string("f 1 2 3\0\n", 9), 4, "binary data"},
        BadObj{"NulInComment", std::string("# \0\n", 4) + kThree, 1, "binary data"},
        BadObj{"Empty", "", 1, "has no faces"}, BadObj{"OnlyComments", "# nothing\n\n", 1, "is not an OBJ file"},
        BadObj{"OtherText", "Dear reader,\nthis is no mesh.\n", 1, "is not an OBJ file"},
        BadObj{"OnlyVertices", kThree, 1, "no faces"},
        BadObj{"OnlyDegenerate", kThree + "f 1 1 2\n", 1, "all 1 triangle of the file are degenerate"},
        BadObj{"LineCountedThroughCrLf", "v 0 0 0\r\nv 1 0 0\r\nv 0 z 0\r\n", 3, "\"z\""},
        BadObj{"LineCountedThroughCr", "v 0 0 0\rv 1 0 0\rv 0 z 0\r", 3, "\"z\""},
        BadObj{"LineCountedThroughContinuation", kThree + "f 1 \\\n2 \\\n9\nf 1 2 3\n", 6, "vertex index 9"}),
    [](const auto& info) { return std::string(info.param.name); });

// Characters that look like plain ones are named, and a line that looks like v or f and is neither is not left out.
INSTANTIATE_TEST_SUITE_P(
    Lookalikes, BadObjFiles,
    testing::Values(
        BadObj{"NoBreakSpaceBehindV", "v 0 0 0\nv\u00a0 1 0 0\nv 0 1 0\nf 1 2 3\n", 2, "no-break space (U+00A0)"},
        BadObj{"NoBreakSpaceBeforeV", "v 0 0 0\n\u00a0v 1 0 0\nv 0 1 0\nf 1 2 3\n", 2, "no-break space (U+00A0)"},
        BadObj{"NoBreakSpaceInPlaceOfABlank", "v 0 0 0\nv\u00a01 0 0\n", 2, "no-break space (U+00A0)"},
        BadObj{"NoBreakSpaceOfLatin1", "v 0 0 0\nv\xa0 1 0 0\n", 2, "no-break space (byte A0)"},
        BadObj{"NoBreakSpaceBehindF", kThree + "f\u00a0 1 2 3\nf 1 2 3\n", 4, "no-break space (U+00A0)"},
        BadObj{"NoBreakSpaceBetweenNumbers", "v 0\u00a00 0\n", 1, "no-break space (U+00A0); write a plain blank"},
        BadObj{"NoBreakSpaceBetweenIndices", kThree + "f 1\u00a02 3\n", 4, "no-break space (U+00A0)"},
        BadObj{"ZeroWidthSpace", kThree + "\u200bf 1 2 3\nf 1 2 3\n", 4, "an invisible character (U+200B); delete it"},
        BadObj{"ByteOrderMarkInTheMiddle", "v 0 0 0\n\ufeffv 1 0 0\n", 2, "a byte order mark (U+FEFF); delete it"},
        BadObj{"ByteOrderMarkTwice", "\ufeff\ufeffv 0 0 0\nv 1 0 0\n", 1, "a byte order mark (U+FEFF); delete it"},
        BadObj{"FullWidthV", "v 0 0 0\n\uff56 1 0 0\n", 2, "a full-width character (U+FF56); write a plain v"},
        BadObj{"MinusSign", "v \u22121 0 0\n", 1, "a minus sign (U+2212); write a plain -"},
        BadObj{"MinusSignOfAnExponent", "v 1e\u22123 0 0\n", 1, "a minus sign (U+2212)"},
        BadObj{"DashOfAnIndex", kThree + "f \u20131 -2 -3\n", 4, "a dash (U+2013)"},
        BadObj{"CurlyQuote", "v \u201c1\u201d 0 0\n", 1, "a curly quote (U+201C)"},
        BadObj{"CapitalV", "v 0 0 0\nV 1 0 0\nv 0 1 0\nf 1 2 3\n", 2, "\"V\" is no statement of OBJ; write v in small"},
        BadObj{"CapitalFirst", "V 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 1, "\"V\" is no statement of OBJ"},
        BadObj{"AllCapitals", "V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n", 1, "\"V\" is no statement of OBJ"},
        BadObj{"CapitalF", kThree + "f 1 2 3\nF 1 2 3\n", 5, "\"F\" is no statement of OBJ; write f in small"},
        BadObj{"CapitalNormal", kThree + "Vn 0 0 1\nf 1 2 3\n", 4, "write vn in small letters"},
        BadObj{"CapitalTexcoord", kThree + "VT 0 0\nf 1 2 3\n", 4, "write vt in small letters"},
        BadObj{"Face", kThree + "face 1 2 3\nf 1 2 3\n", 4, "\"face\" is no statement of OBJ"},
        BadObj{"Vertex", "v 0 0 0\nvertex 1 0 0\nv 0 1 0\n", 2, "\"vertex\" is no statement of OBJ"},
        BadObj{"GluedNumber", "v 0 0 0\nv1 0 0\n", 2, "\"v1\" is no statement of OBJ"},
        BadObj{"GluedIndex", kThree + "f1 2 3\n", 4, "\"f1\" is no statement of OBJ"},
        BadObj{"Quoted", "v 0 0 0\n\"v\" 1 0 0\n", 2, "is no statement of OBJ"},
        BadObj{"StlText", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", 1, "is not an OBJ file"},
        BadObj{"WindowsNanInV", "v 0 0 0\nv 1.#QNAN 0 0\n", 2, "not a finite number"},
        BadObj{"WindowsInfInV", "v 0 0 0\nv 0 -1.#INF00 0\n", 2, "not a finite number"},
        BadObj{"NoNanAtAll", "v 0 0 0\nv 1.# 0 0\n", 2, "\"1.#\" is not a number"},
        BadObj{"OnlyLines", kThree + "l 1 2 3\n", 1, "no faces (f lines), and l (lines) is not drawn"},
        BadObj{"OnlySurfaces", kThree + "cstype bezier\nsurf 0 1 0 1 1 2 3\nend\n", 1, "surf (free-form surfaces)"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(ObjErrors, LimitsEndWithTheirOwnStatus) {
    const TempFolder folder;
    LoadOptions options;
    const auto statusOf = [&](const std::string& text) {
        const auto file = folder.write("limit.obj", text);
        return errorOf([&] { (void)loadObj(file, NormalMode::file, options); }).status();
    };
    options.limits.lineBytes = 100;
    EXPECT_EQ(statusOf(kThree + "f 1 2 3 #" + std::string(200, 'x') + "\n"), ExitStatus::overLimit);
    options = {};
    options.limits.triangles = 1;
    EXPECT_EQ(statusOf(kThree + "f 1 2 3\nf 1 2 3\n"), ExitStatus::overLimit);
    options = {};
    options.limits.polygonCorners = 4;
    EXPECT_EQ(statusOf(kThree + "f 1 2 3 1 2\n"), ExitStatus::overLimit);
    options = {};
    options.limits.fileBytes = 10;
    EXPECT_EQ(statusOf(kThree), ExitStatus::overLimit);
    options = {};
    options.limits.memoryBytes = kBytesAtRest + 2 * kBytesPerTriangle;
    EXPECT_EQ(statusOf(kThree + "f 1 2 3\nf 1 2 3\nf 1 2 3\n"), ExitStatus::overLimit);
    options.limits.memoryBytes += kBytesPerTriangle;
    (void)loadObj(folder.write("limit.obj", kThree + "f 1 2 3\nf 1 2 3\nf 1 2 3\n"), NormalMode::file, options);
    options.limits.pictureBytes = 1; // which the pictures need
    EXPECT_EQ(statusOf(kThree + "f 1 2 3\nf 1 2 3\nf 1 2 3\n"), ExitStatus::overLimit);
    options = {};
    options.limits.memoryBytes = kBytesAtRest + 10 * kBytesPerMeshByte;
    EXPECT_EQ(statusOf(kThree + "f 1 2 3\n"), ExitStatus::overLimit);
}

TEST(ObjErrors, MissingFilesFoldersAndPipesAreNamed) {
    const TempFolder folder;
    const auto messageOf = [](const std::filesystem::path& file) {
        const Error error = errorOf([&] { (void)loadObj(file, NormalMode::file, {}); });
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        return std::string(error.what());
    };
    EXPECT_TRUE(contains(messageOf(folder.path() / "none.obj"), "none.obj: cannot be read: No such file or directory"));
    EXPECT_TRUE(contains(messageOf(folder.path()), "is a directory"));
    const auto pipe = folder.path() / "pipe.obj";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_TRUE(contains(messageOf(pipe), "is not a regular file")); // and it came back at all
    EXPECT_TRUE(contains(messageOf("/dev/zero"), "is not a regular file"));
    EXPECT_TRUE(contains(messageOf(folder.path() / std::string(300, 'n')), "File name too long"));
}

TEST(ObjErrors, UnreadableFileSaysPermissionDenied) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const TempFolder folder;
    const auto file = folder.write("secret.obj", kThree + "f 1 2 3\n");
    std::filesystem::permissions(file, std::filesystem::perms::none);
    EXPECT_TRUE(contains(errorOf([&] { (void)loadObj(file, NormalMode::file, {}); }).what(), "Permission denied"));
}

TEST(ObjErrors, MessagesStayOnOneLineWhateverTheFileHolds) {
    const TempFolder folder;
    const auto file = folder.write("line\nbreak.obj", "v \x01\xff\x1b[31m 0 0\n");
    const std::string message = errorOf([&] { (void)loadObj(file, NormalMode::file, {}); }).what();
    EXPECT_FALSE(contains(message, "\n"));
    EXPECT_TRUE(contains(message, "line\\x0abreak.obj:1:")) << message;
    EXPECT_TRUE(contains(message, "\"\\x01\\xff\\x1b[31m\"")) << message;
}

TEST(ObjErrors, RandomBytesNeverLoadOrCrash) {
    const TempFolder folder;
    std::uint32_t state = 1;
    for (int round = 0; round < 300; ++round) {
        // Every other round uses only characters that OBJ files are made of, to get past the first checks.
        const std::string_view alphabet = "vvvfn  \n\n0123456789.-/\\#e\r\t";
        std::string text = round % 2 ? "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" : "";
        for (int i = 0; i < 400; ++i) {
            state = state * 1664525u + 1013904223u;
            text += round % 2 ? alphabet[(state >> 16) % alphabet.size()] : static_cast<char>(state >> 24);
        }
        const auto file = folder.write("random.obj", text);
        try {
            const ObjFile obj = loadObj(file, NormalMode::file, {});
            for (const uvec3& t : obj.mesh.triangles)
                for (int i = 0; i < 3; ++i)
                    ASSERT_LT(t[i], obj.mesh.positionsMesh.size());
        } catch (const Error& error) {
            EXPECT_NE(error.status(), ExitStatus::bug) << error.what();
        }
    }
}

} // namespace
} // namespace shadowlab::scene
