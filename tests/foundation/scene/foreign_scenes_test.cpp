// Scene files as word processors, web pages and Windows leave them: other encodings, lookalikes of quotes and signs, paths.
// SPDX-License-Identifier: MIT
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

const std::string kCamera = R"("camera": {"position": [0, 1, 5], "target": [0, 0, 0]})";
const std::string kMesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string utf16OfAscii(const std::string& text, bool isBigEndian) {
    std::string bytes;
    for (const char c : text)
        bytes += isBigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
}

TEST(ForeignScenes, Utf16IsConverted) {
    const std::string text = "{" + kCamera + ",\n \"exposure\": 2}";
    for (const bool isBigEndian : {false, true}) {
        const std::string mark = isBigEndian ? "\xfe\xff" : "\xff\xfe";
        EXPECT_EQ(parseSceneJson(mark + utf16OfAscii(text, isBigEndian), "s.json", {})->exposure, 2.0f);
        EXPECT_EQ(parseSceneJson(utf16OfAscii(text, isBigEndian), "s.json", {})->exposure, 2.0f);
        const Error error = errorOf([&] {
            (void)parseSceneJson(mark + utf16OfAscii("{" + kCamera + ",\n \"exposur\": 2}", isBigEndian), "s.json", {});
        });
        EXPECT_TRUE(contains(error.what(), "s.json:2:2: unknown key")) << error.what();
    }
    // Half of a surrogate pair in a text is refused where it stands.
    const Error half = errorOf([&] {
        (void)parseSceneJson("\xff\xfe" + utf16OfAscii("{\n\"a", false) + std::string("\x3d\xd8", 2) +
                                 utf16OfAscii("\": 1}", false),
                             "s.json", {});
    });
    EXPECT_TRUE(contains(half.what(), "s.json:2:")) << half.what();
    EXPECT_TRUE(contains(half.what(), "ill-formed UTF-8")) << half.what();
}

TEST(ForeignScenes, LookalikesAreNamedWhereTheyStand) {
    struct Case {
        std::string text, place, phrase;
    };
    for (const auto& [text, place, phrase] : {
             Case{"{\u201ccamera\u201d: {}}", "1:2", "a curly quote (U+201C)"},
             Case{"{\n \"camera\u201d: {\"position\": [0,1,5]}}", "2:9", "a curly quote (U+201D) stands in this text"},
             Case{"{\n \u201ccamera\": {}}", "2:2", "a curly quote (U+201C)"},
             Case{"{\n \"camera\u201d\n: {}}", "2:9", "a curly quote (U+201D)"},
             Case{"{\n \u2018camera\u2019: {}}", "2:2", "a curly quote (U+2018)"},
             Case{"{\"a\": \u22121}", "1:7", "a minus sign (U+2212) stands here"},
             Case{"{\"a\": 1e\u22123}", "1:9", "a minus sign (U+2212); write a plain -"},
             Case{"{\"a\": [1,\n2\u00a0]}", "2:2", "a no-break space (U+00A0)"},
             Case{"{\n\u00a0 \"a\": 1}", "2:1", "a no-break space (U+00A0); write a plain blank"},
             Case{"{\n\xa0 \"a\": 1}", "2:1", "a no-break space (byte A0)"},
             Case{"{\n\ufeff\"a\": 1}", "2:1", "a byte order mark (U+FEFF); delete it"},
             Case{"{\n\"a\"\uff1a 1}", "2:4", "a full-width character (U+FF1A); write a plain :"},
         }) {
        // The phrase may be cut by "stands here ..., which JSON does not know; REMEDY": look for both halves.
        const std::string message = errorOf([&] { (void)parseSceneJson(text, "x.json", {}); }).what();
        EXPECT_TRUE(message.starts_with("x.json:" + place + ": ")) << message;
        for (std::size_t start = 0; start != std::string::npos;) {
            const std::size_t end = phrase.find("; ", start);
            EXPECT_TRUE(contains(message, phrase.substr(start, end == std::string::npos ? end : end - start)))
                << message;
            start = end == std::string::npos ? end : end + 2;
        }
    }
    const Error key = errorOf([] { (void)parseSceneJson("{" + kCamera + ",\n\"exposure\u00a0\": 1}", "x.json", {}); });
    EXPECT_TRUE(contains(key.what(), "x.json:2:1: unknown key")) << key.what();
    EXPECT_TRUE(contains(key.what(), "with a no-break space (U+00A0); did you mean \"exposure\"?")) << key.what();
    const Error value = errorOf(
        [] { (void)parseSceneJson("{" + kCamera + ",\n\"objects\": [{\"shape\": \"box\u00a0\"}]}", "x.json", {}); });
    EXPECT_TRUE(contains(value.what(), "(its text holds a no-break space (U+00A0))")) << value.what();
    // In a text they are as good as any, and blame for another fault is not put on them.
    const Error other = errorOf([] {
        (void)parseSceneJson("{" + kCamera + ", \"materials\": {\"the \u201cred\u201d one\" {}}}", "x.json", {});
    });
    EXPECT_FALSE(contains(other.what(), "curly")) << other.what();
}

TEST(ForeignScenes, MeshesAreFoundUnderOtherSpellings) {
    const TempFolder folder;
    folder.write("sub/Slat.obj", kMesh);
    folder.write("plain.obj", kMesh);
    const auto scene = [&](const std::string& meshes) {
        return loadScene(folder.write("s.json", "{" + kCamera + ",\n\"objects\": [" + meshes + "]}").string(), {});
    };
    for (const std::string written : {R"(sub\\Slat.obj)", R"(sub/slat.OBJ)", R"(SUB\\SLAT.OBJ)", R"(\"sub/Slat.obj\")",
                                      R"(D:\\models\\sub\\Slat.obj)", R"(/models/sub/Slat.obj)",
                                      R"(file:///D:/models/sub/Slat.obj)", R"(file:///models/sub/Slat.obj)", R"(sub%2FSlat.obj)"}) {
        const auto loaded = scene("{\"mesh\": \"" + written + "\"}");
        EXPECT_EQ(loaded->objects.size(), 1u) << written;
        ASSERT_EQ(loaded->notes.size(), 1u) << written;
        EXPECT_TRUE(contains(loaded->notes[0], "s.json:2:22: the file ")) << loaded->notes[0];
        EXPECT_TRUE(contains(loaded->notes[0], "; \"sub/Slat.obj\" is read in its place")) << loaded->notes[0];
    }
    const auto several =
        scene(R"({"mesh": "sub\\Slat.obj"}, {"mesh": "PLAIN.obj"}, {"mesh": "sub\\Slat.obj"}, {"mesh": "plain.obj"})");
    ASSERT_EQ(several->notes.size(), 1u);
    EXPECT_TRUE(contains(several->notes[0], "(and so for 1 other name)")) << several->notes[0];
    EXPECT_EQ(several->objects[0].name, "Slat");
    EXPECT_EQ(several->objects[0].mesh, several->objects[2].mesh); // one file, one mesh
    const auto messageOf = [&](const std::string& written) {
        return std::string(errorOf([&] { (void)scene("{\"mesh\": \"" + written + "\"}"); }).what());
    };
    EXPECT_TRUE(contains(messageOf(R"(sub\\Slot.obj)"), "No such file")) << messageOf(R"(sub\\Slot.obj)");
    EXPECT_TRUE(contains(messageOf(R"(sub\Slat.obj)"), "in a path write / between folders"));
    EXPECT_TRUE(contains(messageOf(R"(..\\Slat.obj)"), "No such file"));
    EXPECT_TRUE(contains(messageOf("../slat.obj"), "--allow DIR"));
}

} // namespace
} // namespace shadowlab::scene
