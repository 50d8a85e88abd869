// `probe`: what it says of a pixel as text and as JSON, the tree's numbers against sums made here, the diagram, refusals.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <nlohmann/json.hpp>

#include "techniques/foundation/image/png/png.h"
#include "techniques/registry.h"
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Json = nlohmann::json;

class ProbeTest : public CommandTest {
protected:
    Json probed(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "probe");
        arguments.emplace_back("--json");
        const ProgramResult result = succeed(arguments);
        EXPECT_EQ(result.err, "");
        return Json::parse(result.out);
    }
    static Json value(const Json& holder, const std::string& label) {
        for (const Json& fact : holder.at("facts"))
            if (fact.at("label") == label) return fact.at("value");
        return {};
    }
    static dvec3 vector(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }
};

TEST_F(ProbeTest, EveryTechniqueTellsFactsWithoutAGraphicsCard) {
    int asked = 0;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const std::string id(technique.info->id);
        // No library of a graphics card is found there: it must not be looked for.
        const ProgramResult result = succeed({"probe", "box.json", "--pixel", "640,400", "-t", id},
                                             {.environment = {{"LIBGL_DRIVERS_PATH", "/nowhere"}, {"DISPLAY", ""}}});
        EXPECT_NE(result.out.find("\nsurface "), std::string::npos) << result.shown();
        EXPECT_NE(result.out.find(" m\n"), std::string::npos) << "no unit: " << result.out;
        const Json json = probed({"box.json", "--pixel", "640,400", "-t", id});
        for (const char* key : {"scene", "technique", "light", "size", "pixel", "facts", "vectors", "rays", "tree"})
            EXPECT_TRUE(json.contains(key)) << key;
        EXPECT_EQ(json.at("technique"), id);
        EXPECT_EQ(json.at("pixel"), Json({640, 400}));
        EXPECT_EQ(json.at("light"), "key");
        EXPECT_GE(json.at("facts").size(), 4u);
        EXPECT_GT(value(json, "distance from the eye"), 1.0);
        ++asked;
    }
    EXPECT_GE(asked, 6);
}

TEST_F(ProbeTest, DefaultsAreThoseOfTheOtherCommands) {
    const Json json = probed({"box.json", "--pixel", "640,400"});
    EXPECT_EQ(json.at("technique"), "shadow-volume-zfail");
    EXPECT_EQ(json.at("size"), Json({1280, 720}));
    EXPECT_EQ(probed({"box.json", "--pixel", "640,400", "--light", "sun"}).at("light"), "sun");
}

TEST_F(ProbeTest, SameBytesEachTime) {
    for (const bool json : {false, true}) {
        std::vector<std::string> words{"probe", "mirror-and-glass", "--pixel", "500,420", "-t", "ray-traced"};
        if (json) words.emplace_back("--json");
        const std::string first = succeed(words).out;
        EXPECT_GT(first.size(), 4000u);
        EXPECT_EQ(succeed(words, {.environment = {{"SHADOWLAB_THREADS", "1"}}}).out, first);
    }
}

// At each surface: I = a (own light + w_R I_R + w_T I_T), R = u - 2 (u.N) N, and T by Snell's law; V, H and the share of the
// pixel follow. Numbers are printed with all their digits, so what is left is rounding, some 1e-16 for each operation.
TEST_F(ProbeTest, NumbersOfTheTreeAgreeWithSumsMadeHere) {
    int surfaces = 0, splits = 0, refractions = 0, lights = 0;
    for (const char* pixel : {"500,420", "900,450", "420,330", "640,300"}) {
        const Json json = probed({"mirror-and-glass", "--pixel", pixel, "-t", "ray-traced"});
        const Json& tree = json.at("tree");
        for (std::size_t i = 0; i < tree.size(); ++i) {
            const Json& node = tree[i];
            if (node.at("surface").is_null()) continue;
            ++surfaces;
            const dvec3 u = vector(value(node, "u")), n = vector(value(node, "N"));
            EXPECT_LT(glm::length(vector(value(node, "V")) + u), 1e-15);
            EXPECT_NEAR(glm::length(n), 1, 1e-12);
            EXPECT_LT(glm::dot(u, n), 0) << "N is on the side that the ray comes from";
            dvec3 sum = vector(value(node, "own light")), ownLight(0.0);
            for (const Json& child : tree) {
                if (child.at("parent") != i) continue;
                const std::string role = child.at("role");
                if (role.starts_with("shadow")) {
                    ++lights;
                    ownLight += vector(value(child, "I"));
                    const dvec3 h = glm::normalize(vector(value(child, "L")) - u);
                    EXPECT_LT(glm::length(vector(value(child, "H")) - h), 1e-12);
                    continue;
                }
                const bool reflects = role == "reflection";
                const double weight = value(node, reflects ? "weight of I_R" : "weight of I_T");
                const std::string sign = (reflects ? "R" : "T") + node.at("surface").get<std::string>().substr(1);
                EXPECT_EQ(child.at("sign"), sign);
                if (value(child, "I").is_null()) { // total reflection
                    EXPECT_EQ(weight, 0);
                    continue;
                }
                ++splits;
                const dvec3 intensity = vector(value(child, "I"));
                EXPECT_LT(glm::length(vector(value(node, reflects ? "I_R" : "I_T")) - intensity), 1e-15);
                sum += weight * intensity;
                const double share = value(child, "contribution");
                EXPECT_NEAR(share,
                            weight * value(node, "attenuation").get<double>() *
                                value(node, "contribution").get<double>(),
                            1e-12);
                const dvec3 way = vector(value(child, "u"));
                if (reflects) {
                    EXPECT_LT(glm::length(way - (u - 2 * glm::dot(u, n) * n)), 1e-9);
                } else {
                    ++refractions;
                    const Json ior = value(node, "index of refraction");
                    // Snell: the parts along the surface are as the indices are, the other way round.
                    const dvec3 inward = u - glm::dot(u, n) * n, outward = way - glm::dot(way, n) * n;
                    EXPECT_LT(glm::length(ior[0].get<double>() * inward - ior[1].get<double>() * outward), 1e-9);
                }
            }
            sum *= value(node, "attenuation").get<double>();
            EXPECT_LT(glm::length(vector(value(node, "I")) - sum), 1e-12);
            const dvec3 own = vector(value(node, "own light"));
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(own, ownLight - 1e-12))) << "emission and ambient come on top";
        }
    }
    std::cout << surfaces << " surfaces, " << splits << " rays below them, " << refractions << " refracted\n";
    EXPECT_GT(surfaces, 12);
    EXPECT_GT(splits, 10);
    EXPECT_GT(refractions, 4);
    EXPECT_GE(lights, surfaces);
}

TEST_F(ProbeTest, DiagramIsWrittenWholeAndTheSameEachTime) {
    const std::vector<std::string> words{"probe", "mirror-and-glass", "--pixel",   "500,420",
                                         "-t",    "ray-traced",       "--diagram", "tree.svg"};
    succeed(words);
    const std::string first = fileContent(folder.path() / "tree.svg");
    EXPECT_TRUE(first.starts_with("<?xml"));
    EXPECT_TRUE(first.ends_with("</svg>\n"));
    succeed(words);
    EXPECT_EQ(fileContent(folder.path() / "tree.svg"), first);
}

TEST_F(ProbeTest, DiagramIsAPictureWhereItsNameSaysSo) {
    const std::vector<std::string> words{"probe", "mirror-and-glass", "--pixel",   "500,420",
                                         "-t",    "ray-traced",       "--diagram", "tree.png"};
    succeed(words);
    const std::string first = fileContent(folder.path() / "tree.png");
    const std::vector<std::uint8_t> bytes(first.begin(), first.end());
    const image::DecodedPng png = image::decodePng(bytes, "tree.png");
    EXPECT_EQ(png.image.width, 1920);
    int ink = 0;
    for (int y = 0; y < png.image.height; ++y)
        for (int x = 0; x < png.image.width; ++x)
            ink += png.image.at(x, y).g < 128;
    EXPECT_GT(ink, 20000); // lines and letters
    succeed(words);
    EXPECT_EQ(fileContent(folder.path() / "tree.png"), first);
}

// Whatever the patches are: places, angles and form factors have to agree with one another.
TEST_F(ProbeTest, ASecondPixelSaysWhichTwoPatchesAreAskedAbout) {
    const auto asked = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"cornell-room",        "--pixel", "500,690", "-t", "radiosity", "--set",
                                       "radiosity.patches=60"};
        words.insert(words.end(), more.begin(), more.end());
        return probed(words);
    };
    const Json red = asked({"--partner", "300,400"}), green = asked({"--partner", "980,400"}), alone = asked({});
    EXPECT_EQ(red.at("partner"), Json({300, 400}));
    EXPECT_TRUE(alone.at("partner").is_null());
    EXPECT_EQ(value(red, "of"), "left wall");
    EXPECT_EQ(value(green, "of"), "right wall");
    int compared = 0;
    for (const Json& one : {red, green, alone}) {
        const Json &j = one.at("exchange").at("j"), &k = one.at("exchange").at("k");
        EXPECT_EQ(j.at("object"), "floor");
        EXPECT_EQ(k.at("object"), value(one, "of"));
        const dvec3 way = vector(k.at("centre")) - vector(j.at("centre"));
        const double r = glm::length(way);
        EXPECT_NEAR(value(one, "r").get<double>(), r, 1e-12);
        const double cosJ = glm::dot(vector(j.at("normal")), way) / r,
                     cosK = -glm::dot(vector(k.at("normal")), way) / r;
        EXPECT_NEAR(value(one, "phi_j").get<double>(), glm::degrees(std::acos(cosJ)), 1e-6);
        EXPECT_NEAR(value(one, "phi_k").get<double>(), glm::degrees(std::acos(cosK)), 1e-6);
        EXPECT_NEAR(value(one, "cos phi_j cos phi_k dA_k / (pi r^2)").get<double>(),
                    cosJ * cosK * k.at("area").get<double>() / (3.14159265358979 * r * r), 1e-12);
        const double jk = one.at("exchange").at("F_jk"), kj = one.at("exchange").at("F_kj");
        EXPECT_GT(jk, 0);
        EXPECT_NEAR(jk * j.at("area").get<double>(), kj * k.at("area").get<double>(), 1e-15) << "reciprocity";
        EXPECT_EQ(value(one, "F_jk"), jk);
        ++compared;
    }
    EXPECT_EQ(compared, 3);
    // The parameter says it where no second pixel does.
    const std::uint32_t k = value(red, "k: the other patch");
    const Json byNumber = asked({"--set", "radiosity.to-patch=" + std::to_string(k)});
    EXPECT_EQ(byNumber.at("exchange"), red.at("exchange"));
    EXPECT_EQ(asked({"--partner", "980,400", "--set", "radiosity.to-patch=" + std::to_string(k)}).at("exchange"),
              green.at("exchange"));
}

// What the numbers say has to agree with the decision, and lists with their sums.
TEST_F(ProbeTest, TellsWhatDecidedOnTheShadow) {
    int faces = 0, taps = 0, covers = 0, shadowed = 0;
    for (const char* pixel : {"640,400", "560,470", "700,520", "500,430", "760,450"}) {
        for (const char* technique : {"shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume"}) {
            const Json one = probed({"box.json", "--pixel", pixel, "-t", technique});
            const Json& volume = one.at("volume");
            if (volume.is_null()) continue; // background
            int count = volume.at("start"), before = 0, beyond = 0;
            for (const Json& face : volume.at("faces")) {
                ++faces;
                const int sign = face.at("sign");
                (face.at("beyond").get<bool>() ? beyond : before) += sign;
                count += face.at("counted").get<int>();
                EXPECT_EQ(face.at("part") == "side", face.at("triangle").is_null());
            }
            EXPECT_EQ(count, volume.at("count").get<int>());
            EXPECT_EQ(before, volume.at("zPass").at("n_f").get<int>() - volume.at("zPass").at("n_b").get<int>());
            EXPECT_EQ(-beyond, volume.at("zFail").at("n_b").get<int>() - volume.at("zFail").at("n_f").get<int>());
            EXPECT_EQ(before + volume.at("eyeIn").get<int>(), -beyond) << "both ways tell of the same point";
            shadowed += volume.at("stencil") != 0;
            EXPECT_TRUE(one.at("map").is_null() && one.at("plane").is_null());
            EXPECT_TRUE(one.at("decision").at("error").is_null());
        }
        const Json map = probed({"box.json", "--pixel", pixel, "-t", "shadow-map"});
        if (!map.at("map").is_null() && !map.at("map").at("taps").empty()) {
            double share = 0;
            for (const Json& tap : map.at("map").at("taps")) {
                ++taps;
                EXPECT_EQ(tap.at("lit").get<bool>(),
                          tap.at("compared").get<double>() <= tap.at("stored").get<double>());
                share += tap.at("lit").get<bool>() ? tap.at("weight").get<double>() : 0;
            }
            if (!map.at("decision").at("turnedAway").get<bool>()) {
                EXPECT_NEAR(share, map.at("decision").at("visibility").get<double>(), 1e-6);
            }
        }
        const Json plane = probed({"box.json", "--pixel", pixel, "-t", "planar"});
        if (plane.at("plane").is_null()) continue;
        for (const Json& cover : plane.at("plane").at("covers")) {
            ++covers;
            EXPECT_EQ(cover.at("casts").get<bool>(), cover.at("why").is_null());
        }
    }
    EXPECT_GT(faces, 10);
    EXPECT_GT(taps, 8);
    EXPECT_GT(covers, 2);
    EXPECT_GT(shadowed, 0);
}

// Every filter tells what it read and what follows from it; the decision is the same number everywhere.
TEST_F(ProbeTest, EveryFilterTellsWhatItReadAndWhatItDecided) {
    int taps = 0, moments = 0, searches = 0;
    for (const char* filter : {"hard", "hw2x2", "pcf", "disc", "pcss", "vsm", "esm", "evsm", "msm"})
        for (const char* pixel : {"640,400", "760,520"}) {
            std::vector<std::string> words{
                "box.json", "--pixel", pixel, "-t", "shadow-map", "--set", std::string("shadow-map.filter=") + filter};
            if (filter == std::string("pcss")) words.insert(words.end(), {"--set", "shadow-map.light-radius=0.2"});
            const Json json = probed(words);
            if (json.at("map").is_null() || json.at("decision").is_null()) continue;
            const Json& map = json.at("map");
            const double visibility = json.at("decision").at("visibility");
            if (json.at("decision").at("turnedAway").get<bool>()) continue;
            double lit = 0;
            for (const Json& tap : map.at("taps")) {
                ++taps;
                lit += tap.at("lit").get<bool>() ? tap.at("weight").get<double>() : 0;
                EXPECT_EQ(tap.at("lit").get<bool>(), tap.at("compared") <= tap.at("stored")) << filter;
                for (int axis = 0; axis < 2; ++axis)
                    EXPECT_EQ(std::floor(tap.at("place").at(static_cast<std::size_t>(axis)).get<double>()),
                              tap.at("texel").at(static_cast<std::size_t>(axis)).get<double>());
            }
            if (!map.at("taps").empty()) {
                EXPECT_NEAR(lit, visibility, 1e-6) << filter;
            }
            if (!map.at("moments").is_null() && !map.at("moments").at("read").empty()) { // empty: outside the map
                ++moments;
                EXPECT_EQ(map.at("moments").at("visibility").get<double>(), visibility) << filter;
                EXPECT_GE(map.at("moments").at("read").size(), 2u);
            }
            if (!map.at("search").is_null()) {
                ++searches;
                int found = 0;
                for (const Json& look : map.at("search").at("looks"))
                    found += look.at("lit").get<bool>() ? 0 : 1;
                EXPECT_EQ(map.at("search").at("found").get<int>(), found);
            }
        }
    EXPECT_GT(taps, 30);
    EXPECT_GE(moments, 4);
    EXPECT_GE(searches, 1);
}

TEST_F(ProbeTest, PlanarDrawsAndSaysThatThereIsNoPlane) {
    const std::vector<std::string> words{"mirror-and-glass", "--pixel", "500,420", "-t", "planar"};
    const Json json = probed(words);
    EXPECT_TRUE(json.at("plane").at("plane").is_null());
    EXPECT_GE(json.at("plane").at("others").size(), 1u);
    std::vector<std::string> drawing = words;
    drawing.insert(drawing.begin(), "probe");
    drawing.insert(drawing.end(), {"--diagram", "none.svg"});
    succeed(drawing);
    EXPECT_NE(fileContent(folder.path() / "none.svg").find("No receiver plane here"), std::string::npos);
}

TEST_F(ProbeTest, TheFiguresOfTheShadowAreTheSameEachTime) {
    for (const char* technique : {"planar", "shadow-map", "shadow-volume"}) {
        const std::vector<std::string> words{"probe", "box.json", "--pixel",   "700,520",
                                             "-t",    technique,  "--diagram", "shadow.svg"};
        succeed(words);
        const std::string first = fileContent(folder.path() / "shadow.svg");
        EXPECT_TRUE(first.ends_with("</svg>\n")) << technique;
        EXPECT_NE(first.find("the plane through eye, light and point"), std::string::npos) << technique;
        succeed(words, {.environment = {{"SHADOWLAB_THREADS", "1"}}});
        EXPECT_EQ(fileContent(folder.path() / "shadow.svg"), first) << technique;
    }
}

TEST_F(ProbeTest, OfTheSamePatchTwiceThereIsNoPairAndOthersTakeNoNoticeOfASecondPixel) {
    const Json same = probed({"cornell-room", "--pixel", "500,690", "--partner", "500,690", "-t", "radiosity", "--set",
                              "radiosity.patches=60"});
    EXPECT_TRUE(same.at("exchange").at("k").is_null());
    EXPECT_TRUE(value(same, "k: the other patch").get<std::string>().starts_with("none"));
    Json with = probed({"box.json", "--pixel", "640,400", "--partner", "600,500", "-t", "ray-traced"});
    const Json without = probed({"box.json", "--pixel", "640,400", "-t", "ray-traced"});
    EXPECT_EQ(with.at("partner"), Json({600, 500}));
    with["partner"] = nullptr;
    EXPECT_EQ(with, without);
    EXPECT_TRUE(without.at("exchange").is_null());
}

TEST_F(ProbeTest, RadiositysDiagramIsThatOfTwoSurfaces) {
    const std::vector<std::string> words{"probe",     "cornell-room", "--pixel",   "500,690", "--partner",
                                         "300,400",   "-t",           "radiosity", "--set",   "radiosity.patches=60",
                                         "--diagram", "pair.svg"};
    succeed(words);
    const std::string first = fileContent(folder.path() / "pair.svg");
    for (const char* part : {"<?xml", ">floor<", ">left wall<", "Lambertian reflector", "Form factor"})
        EXPECT_NE(first.find(part), std::string::npos) << part;
    succeed(words, {.environment = {{"SHADOWLAB_THREADS", "1"}}});
    EXPECT_EQ(fileContent(folder.path() / "pair.svg"), first);
}

TEST_F(ProbeTest, Refusals) {
    expectRefused({"probe", "box.json"}, 2, {"--pixel"});
    expectRefused({"probe", "box.json", "--pixel", "1280,10"}, 2, {"1280,10", "outside", "1279"});
    expectRefused({"probe", "box.json", "--pixel=-1,10"}, 2, {"outside"});
    expectRefused({"probe", "box.json", "--pixel", "8,8", "--size", "8x8"}, 2, {"outside", "0 to 7"});
    for (const char* pixel : {"10", "10,", "a,b", "10,20,30", "10x20", "1.5,2"})
        expectRefused({"probe", "box.json", "--pixel", pixel}, 2, {"--pixel", "320,180"});
    expectRefused({"probe", "box.json", "--pixel", "1,1", "--partner", "1280,10"}, 2, {"--partner", "outside", "1279"});
    expectRefused({"probe", "box.json", "--pixel", "1,1", "--partner", "10"}, 2, {"--partner", "320,180"});
    expectRefused({"probe", "box.json", "--partner", "1,1"}, 2, {"--pixel"});
    expectRefused({"probe", "box.json", "--pixel", "1,1", "-t", "shadow-mop"}, 2, {"shadow-map"});
    expectRefused({"probe", "box.json", "--pixel", "1,1", "-t", "planar,ray-traced"}, 2, {"one technique"});
    expectRefused({"probe", "box.json", "--pixel", "1,1", "--light", "kee"}, 2, {"key"});
    expectRefused({"probe", "box.json", "--pixel", "1,1", "--set", "ray-traced.depth=1"}, 2, {"ray-traced"});
    expectRefused({"probe", "gone.json", "--pixel", "1,1"}, 3, {"gone.json"});
    const std::vector<std::string> diagram{"probe", "box.json", "--pixel", "640,400", "-t", "ray-traced", "--diagram"};
    const auto with = [&](const char* name) {
        std::vector<std::string> words = diagram;
        words.emplace_back(name);
        return words;
    };
    expectRefused(with("tree.jpg"), 2, {".svg"});
    expectRefused(with("nowhere/tree.svg"), 4, {"nowhere"});
    expectRefused({"probe", "box.json", "--pixel", "640,400", "-t", "unshadowed", "--diagram", "tree.svg"}, 2,
                  {"unshadowed", "ray-traced"});
    expectRefused({"probe", "box.json", "--pixel", "0,0", "-t", "ray-traced", "--diagram", "tree.svg"}, 2,
                  {"background"});
    expectRefused({"capture", "box.json", "-o", "a.png", "--pixel", "1,1"}, 2, {"--stage outside"});
    expectRefused({"capture", "box.json", "-o", "a.png", "-t", "radiosity", "--stage", "row-sums", "--pixel", "1,1"}, 2,
                  {"--pixel", "form-factors"});
    expectRefused({"capture", "box.json", "-o", "a.png", "--stage", "outside", "--partner", "1,1"}, 2,
                  {"--partner", "--pixel X,Y"});
    expectRefused({"capture", "box.json", "-o", "a.png", "--stage", "outside", "--pixel", "1,1", "--partner", "1,720"},
                  2, {"--partner", "outside"});
}

TEST_F(ProbeTest, WithoutLightsThereIsStillASurface) {
    folder.write("dark.json", sceneText(kCamera, R"("lights": [])", kBoxOnFloor));
    const ProgramResult result = succeed({"probe", "dark.json", "--pixel", "640,400", "-t", "ray-traced"});
    EXPECT_NE(result.err.find("no lights"), std::string::npos);
    EXPECT_NE(result.out.find("eye ray to S1"), std::string::npos) << result.out;
}

} // namespace
} // namespace shadowlab::testing
