// Everything a user can get wrong on the command line, one row each: status, one line, the remedy, nothing written.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

struct Refusal {
    std::string name; ///< of the test
    std::vector<std::string> arguments;
    int status;
    std::vector<std::string> says;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) { *stream << refusal.name; }

std::vector<std::string> operator+(std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

const std::vector<std::string> kCapture = {"capture", "box.json", "-o", "x.png"};
const std::vector<std::string> kTwo = kCapture + std::vector<std::string>{"-t", "shadow-map,shadow-volume-zfail"};

const std::vector<Refusal> kUsage = {
    {"UnknownCommand", {"captrue", "box.json"}, 2, {"'captrue'", "did you mean \"capture\"?"}},
    {"UnknownScene", {"still-lief"}, 2, {"'still-lief'", "did you mean \"still-life\"?"}},
    {"NothingNear", {"qqqqqqqqq"}, 2, {"'qqqqqqqqq' is neither a command nor a scene", "--help"}},
    {"UnknownTopOption", {"--vesion"}, 2, {"did you mean \"--version\"?"}},
    {"WordBeforeTheCommand", {"box.json", "capture"}, 2, {"'box.json' is one argument too many"}},
    {"NoScene", {"capture"}, 2, {"SCENE is missing"}},
    {"NoOutput", {"capture", "box.json"}, 2, {"--output is missing", "-o OUT.png"}},
    {"UnknownOption", kCapture + std::vector<std::string>{"--siez", "8x8"}, 2, {"no option '--siez'", "\"--size\""}},
    {"UnknownOptionWithEquals", kCapture + std::vector<std::string>{"--siez=8x8"}, 2, {"\"--size\""}},
    {"UnknownOptionBeforeAllElse", {"capture", "--ouput", "x.png"}, 2, {"did you mean \"--output\"?"}},
    {"OneDash", kCapture + std::vector<std::string>{"-size", "8x8"}, 2, {"\"--size\""}},
    {"UnknownLetter", kCapture + std::vector<std::string>{"-q"}, 2, {"no option '-q'", "capture --help"}},
    {"OneArgumentTooMany", kCapture + std::vector<std::string>{"more"}, 2, {"'more' is one argument too many"}},
    {"MissingValue", kCapture + std::vector<std::string>{"--size"}, 2, {"--size: its value is missing"}},
    {"EmptyValue", kCapture + std::vector<std::string>{"--size", ""}, 2, {"--size: an empty text"}},
    {"EmptyOutput", {"capture", "box.json", "-o", ""}, 2, {"--output: an empty text"}},
    {"EmptyScene", {"capture", "", "-o", "x.png"}, 2, {"SCENE: an empty text"}},
    {"GivenTwice", kCapture + std::vector<std::string>{"-o", "y.png"}, 2, {"--output is given 2 times"}},
    {"SizeZero", kCapture + std::vector<std::string>{"--size", "0x0"}, 2, {"'0x0'", "1280x720"}},
    {"SizeNegative", kCapture + std::vector<std::string>{"--size", "-4x4"}, 2, {"WIDTHxHEIGHT"}},
    {"SizeHalf", kCapture + std::vector<std::string>{"--size", "640x"}, 2, {"'640x'"}},
    {"SizeOneNumber", kCapture + std::vector<std::string>{"--size", "640"}, 2, {"'640'"}},
    {"SizeWords", kCapture + std::vector<std::string>{"--size", "8x8 "}, 2, {"'8x8 '"}},
    {"SizeNotWhole", kCapture + std::vector<std::string>{"--size", "8.5x8"}, 2, {"'8.5x8'"}},
    {"SizeTooSmallForItsPictures", kTwo + std::vector<std::string>{"--size", "1x8"}, 2, {"too small for 2 pictures"}},
    {"SizeOverLimit", kCapture + std::vector<std::string>{"--size", "100000x100000"}, 6, {"16384", "smaller size"}},
    {"SizeOverAnyNumber", kCapture + std::vector<std::string>{"--size", "99999999999999999999x1"}, 6, {"16384"}},
    {"SamplesOverLimit", kCapture + std::vector<std::string>{"--size", "16384x16384"}, 6, {"268435456", "134217728"}},
    {"SupersampleTimesSize",
     kCapture + std::vector<std::string>{"--size", "2000x20", "--supersample", "16"},
     6,
     {"2000x20", "16", "32000", "16384"}},
    {"SplitPicturesAreWhole",
     kTwo + std::vector<std::string>{"--size", "12000x8000", "--layout", "split"},
     6,
     {"192000000", "134217728"}},
    {"SupersampleZero", kCapture + std::vector<std::string>{"--supersample", "0"}, 2, {"from 1 to 16"}},
    {"SupersampleSeventeen",
     kCapture + std::vector<std::string>{"--supersample", "17"},
     6,
     {"16", "--limit supersample"}},
    {"UnknownLayout",
     kTwo + std::vector<std::string>{"--layout", "sied"},
     2,
     {"--layout: 'sied'", "did you mean \"side\"?"}},
    {"ContradictoryLayout",
     kTwo + std::vector<std::string>{"--layout", "single"},
     2,
     {"single shows one technique, 2 are given", "side, split or grid"}},
    {"Labels", kCapture + std::vector<std::string>{"--labels", "yes"}, 2, {"--labels: 'yes'", "true", "false"}},
    {"Backend", kCapture + std::vector<std::string>{"--backend", "vulkan"}, 2, {"vulkan", "auto, egl, osmesa, window"}},
    {"FramesWithoutHashes",
     kCapture + std::vector<std::string>{"--frames", "3"},
     2,
     {"numbers of 3 frames", "name_####.png"}},
    {"FramesZero", kCapture + std::vector<std::string>{"--frames", "0"}, 2, {"from 1 to 100000"}},
    {"OrbitOfOneFrame",
     kCapture + std::vector<std::string>{"--orbit-light", "90"},
     2,
     {"--orbit-light", "add --frames"}},
    {"OrbitNotANumber",
     {"capture", "box.json", "-o", "x_#.png", "--frames", "2", "--orbit-camera", "nan"},
     2,
     {"--orbit-camera: 'nan'"}},
    {"OrbitComma", {"capture", "box.json", "-o", "x_#.png", "--frames", "2", "--orbit-camera", "1,5"}, 2, {"'1,5'"}},
    {"PathAndOrbit",
     {"capture", "box.json", "-o", "x_#.png", "--frames", "2", "--path", "path.json", "--orbit-camera", "90"},
     2,
     {"--orbit-camera and --path", "give one of them"}},
    {"PathWithoutHashes", kCapture + std::vector<std::string>{"--path", "path.json"}, 2, {"3 frames", "name_####.png"}},
    {"PathTwice",
     kCapture + std::vector<std::string>{"--path", "path.json", "--path", "path.json"},
     2,
     {"--path is given 2 times"}},
    {"OutputLinksToThePath",
     {"capture", "box.json", "-o", "pathlink_.png", "--path", "path.json"},
     2,
     {"'pathlink_.png' is also the path"}},
    {"StatsAreThePath",
     kCapture + std::vector<std::string>{"--frames", "1", "--path", "path.json", "--stats", "path.json"},
     2,
     {"'path.json' is also the path"}},
    {"OutputEnding", {"capture", "box.json", "-o", "x.jpg"}, 2, {"'x.jpg' does not end in .png"}},
    {"OutputIsTheScene", {"capture", "box.json", "-o", "box.json"}, 2, {".png"}},
    {"OutputLinksToTheScene", {"capture", "box.json", "-o", "link.png"}, 2, {"'link.png' is also the scene"}},
    {"StatsEnding", kCapture + std::vector<std::string>{"--stats", "x.txt"}, 2, {"'x.txt' does not end in .json"}},
    {"StatsAreTheScene",
     kCapture + std::vector<std::string>{"--stats", "./box.json"},
     2,
     {"'./box.json' is also the scene"}},
    {"UnknownTechnique",
     kCapture + std::vector<std::string>{"-t", "shadow-mapp"},
     2,
     {"'shadow-mapp'", "did you mean \"shadow-map\"?"}},
    {"EmptyTechnique", kCapture + std::vector<std::string>{"-t", "shadow-map,"}, 2, {"no technique is called ''"}},
    {"UnknownStage",
     kCapture + std::vector<std::string>{"--stage", "visibilty"},
     2,
     {"has no stage 'visibilty'", "\"visibility\""}},
    {"UnknownPass", kCapture + std::vector<std::string>{"--stage", "pass:ligth"}, 2, {"\"pass:light\""}},
    {"StageOfOneOfTwo",
     kTwo + std::vector<std::string>{"--stage", "light-depth"},
     2,
     {"'shadow-volume-zfail' has no stage 'light-depth'"}},
    {"StageOfAllLights",
     kCapture + std::vector<std::string>{"--stage", "lights-off@key"},
     2,
     {"does not belong to one light"}},
    {"StageOfUnknownLight",
     kCapture + std::vector<std::string>{"--stage", "visibility@kye"},
     2,
     {"no light 'kye'", "\"key\""}},
    {"UnknownLight", kCapture + std::vector<std::string>{"--light", "snu"}, 2, {"no light 'snu'", "\"sun\""}},
    {"SetNoSetting",
     kCapture + std::vector<std::string>{"--set", "wrap"},
     2,
     {"'wrap' is not a setting", "[SLOT:]ID.PARAM=VALUE"}},
    {"SetUnknownTechnique",
     kCapture + std::vector<std::string>{"--set", "shadow-mpa.cull=true"},
     2,
     {"\"shadow-map\""}},
    {"SetTechniqueNotShown",
     kCapture + std::vector<std::string>{"--set", "shadow-map.cull=true"},
     2,
     {"no slot shows shadow-map", "-t"}},
    {"SetUnknownParameter",
     kTwo + std::vector<std::string>{"--set", "shadow-map.resolutoin=64"},
     2,
     {"\"resolution\""}},
    {"SetOutOfRange",
     kTwo + std::vector<std::string>{"--set", "shadow-map.resolution=63"},
     2,
     {"'63' is out of range", "64..32768 texels"}},
    {"SetNotWhole", kTwo + std::vector<std::string>{"--set", "shadow-map.resolution=64.5"}, 2, {"64..32768"}},
    {"SetNotANumber", kTwo + std::vector<std::string>{"--set", "shadow-map.slope-bias=nan"}, 2, {"'nan'"}},
    {"SetComma", kTwo + std::vector<std::string>{"--set", "shadow-map.slope-bias=1,5"}, 2, {"'1,5'"}},
    {"SetNoChoice", kTwo + std::vector<std::string>{"--set", "shadow-map.filter=soft"}, 2, {"hard|hw2x2|pcf"}},
    {"SetNoBoolean", kTwo + std::vector<std::string>{"--set", "shadow-map.cull=1"}, 2, {"false|true"}},
    {"SetSlotThree", kTwo + std::vector<std::string>{"--set", "3:shadow-map.cull=true"}, 2, {"from 1 to 2"}},
    {"SetSlotZero", kTwo + std::vector<std::string>{"--set", "0:shadow-map.cull=true"}, 2, {"slot number"}},
    {"SetSlotWord", kTwo + std::vector<std::string>{"--set", "a:shadow-map.cull=true"}, 2, {"slot number"}},
    {"SetSlotOfAnother",
     kTwo + std::vector<std::string>{"--set", "2:shadow-map.cull=true"},
     2,
     {"no slot 2 shows shadow-map"}},
    {"ListUnknown", {"list", "technique"}, 2, {"\"techniques\""}},
    {"ListOptionValue", {"list", "scenes", "more"}, 2, {"'more' is one argument too many"}},
    {"DemoOfNothing", {"demo", "no-such-scene"}, 3, {"no-such-scene"}},
};

const std::vector<Refusal> kInputs = {
    {"UnknownBuiltIn", {"capture", "still-lfie", "-o", "x.png"}, 3, {"'still-lfie'", "\"still-life\""}},
    {"ControlCharacters", {"capture", "a\nb\x1b[1m", "-o", "x.png"}, 3, {"a\\x0ab\\x1b"}},
    {"NotUtf8", {"capture", "\xff.json", "-o", "x.png"}, 3, {"\\xff.json"}},
    {"MissingJson", {"capture", "none.json", "-o", "x.png"}, 3, {"none.json", "No such file"}},
    {"MissingObj", {"capture", "none.obj", "-o", "x.png"}, 3, {"none.obj", "No such file"}},
    {"Folder", {"capture", "folder.json", "-o", "x.png"}, 3, {"folder.json", "folder"}},
    {"Fifo", {"capture", "fifo.obj", "-o", "x.png"}, 3, {"fifo.obj"}},
    {"FifoJson", {"capture", "fifo.json", "-o", "x.png"}, 3, {"fifo.json"}},
    {"OtherEnding", {"capture", "notes.txt", "-o", "x.png"}, 3, {"notes.txt", ".json", ".obj"}},
    {"BrokenJson", {"capture", "broken.json", "-o", "x.png"}, 3, {"broken.json:3:"}},
    {"EmptyJson", {"capture", "empty.json", "-o", "x.png"}, 3, {"empty.json:1:1"}},
    {"UnknownKey", {"capture", "key.json", "-o", "x.png"}, 3, {"key.json:2:", "\"ligths\"", "\"lights\""}},
    {"BadObjIndex", {"capture", "index.obj", "-o", "x.png"}, 3, {"index.obj:4:", "vertex index 9"}},
    {"EmptyObj", {"capture", "empty.obj", "-o", "x.png"}, 3, {"empty.obj"}},
    {"PictureNamedObj", {"capture", "picture.obj", "-o", "x.png"}, 3, {"picture.obj"}},
    {"MeshMissing", {"capture", "mesh.json", "-o", "x.png"}, 3, {"mesh.json:", "none.obj"}},
    {"MeshOutside", {"capture", "outside.json", "-o", "x.png"}, 3, {"outside.json:", "--allow"}},
    {"AllowMissing", kCapture + std::vector<std::string>{"--allow", "nowhere"}, 2, {"--allow", "'nowhere'"}},
    {"AllowFile", kCapture + std::vector<std::string>{"--allow", "box.json"}, 2, {"--allow", "'box.json'"}},
    {"PathMissing", kCapture + std::vector<std::string>{"--path", "none.json"}, 3, {"none.json", "No such file"}},
    {"PathFifo", kCapture + std::vector<std::string>{"--path", "fifo.json"}, 3, {"fifo.json"}},
    {"PathOfOtherLights",
     kCapture + std::vector<std::string>{"--path", "lights.json"},
     3,
     {"lights.json:2:", "no such light", "did you mean \"key\"?"}},
    {"DashFile", {"capture", "-o", "x.png", "--", "-none.json"}, 3, {"-none.json", "No such file"}},
};

class Refusals : public CommandTest, public ::testing::WithParamInterface<Refusal> {
protected:
    void SetUp() override {
        std::filesystem::create_symlink("box.json", folder.path() / "link.png");
        std::filesystem::create_directory(folder.path() / "folder.json");
        for (const char* name : {"fifo.obj", "fifo.json"})
            ASSERT_EQ(::mkfifo((folder.path() / name).c_str(), 0600), 0);
        folder.write("path.json", R"([{"frame": 1}, {"frame": 3, "camera": {"position": [0, 3, 5]}}])");
        folder.write("lights.json", "[{\"frame\": 1,\n\"lights\": [{\"name\": \"kye\"}]}]");
        std::filesystem::create_symlink("path.json", folder.path() / "pathlink_.png");
        folder.write("notes.txt", "a note");
        folder.write("broken.json", "{\n\"camera\":\n{]\n}");
        folder.write("empty.json", "");
        folder.write("key.json", "{\n\"ligths\": []}");
        folder.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
        folder.write("empty.obj", "");
        folder.write("picture.obj", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
        folder.write("mesh.json", sceneText(kCamera, kTwoLights, R"("objects": [{"mesh": "none.obj"}])"));
        folder.write("outside.json", sceneText(kCamera, kTwoLights, R"("objects": [{"mesh": "/etc/hostname"}])"));
    }
};

TEST_P(Refusals, OneLineOneStatusNothingWritten) {
    expectRefused(GetParam().arguments, GetParam().status, GetParam().says);
}

std::string nameOf(const ::testing::TestParamInfo<Refusal>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Usage, Refusals, ::testing::ValuesIn(kUsage), nameOf);
INSTANTIATE_TEST_SUITE_P(Input, Refusals, ::testing::ValuesIn(kInputs), nameOf);

} // namespace
} // namespace shadowlab::testing
