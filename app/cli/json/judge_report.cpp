// SPDX-License-Identifier: MIT
#include "app/cli/json/judge_report.h"

#include "app/cli/json/json_values.h"
#include "app/cli/text_table.h"
#include "app/picture/verdict_reasons.h"

namespace shadowlab::cli {

namespace {

using foreign::Calibration;
using foreign::JudgedPicture;

/// Of the camera that is told by the squares, which may be no pinhole at all: `worstPx` says it.
Json fittedCameraJson(const foreign::FittedCamera& camera) {
    return {{"movedWorld", vectorJson(camera.movedWorld)},
            {"awayDegrees", camera.awayDegrees},
            {"rolledDegrees", camera.rolledDegrees},
            {"fovYDegrees", camera.fovYDegrees},
            {"worstPx", camera.worstPx}};
}

Json calibrationJson(const Calibration& calibration) {
    Json faults = Json::array();
    for (const foreign::FoundFault& fault : calibration.faults)
        faults.push_back({{"fault", foreign::toText(fault.fault)}, {"what", fault.what}, {"remedy", fault.remedy}});
    return {{"right", calibration.isRight()},
            {"faults", faults},
            {"likeness", calibration.likeness},
            {"orientation", textJson(foreign::toText(calibration.orientation))},
            {"shiftPx", calibration.shiftPx ? vectorJson(*calibration.shiftPx) : Json(nullptr)},
            {"scale", calibration.shiftPx ? vectorJson(calibration.scale) : Json(nullptr)},
            {"turnDegrees", calibration.shiftPx ? Json(calibration.turnDegrees) : Json(nullptr)},
            {"wholeSquares", calibration.wholeSquares},
            {"code", calibration.code ? Json(*calibration.code) : Json(nullptr)},
            {"camera", calibration.camera ? fittedCameraJson(*calibration.camera) : Json(nullptr)},
            {"encoding", calibration.curve ? Json(foreign::toText(*calibration.curve)) : Json(nullptr)},
            {"encodingErrorLevels", calibration.curveError},
            {"exposure", calibration.exposure}};
}

Json judgedJson(const JudgedPicture& judged) {
    const judge::Counts& counts = judged.errors.judgement.counts;
    Json json;
    json["truth"] = truthName(judged.truthOf);
    json["pixels"] = counts.pixels;
    json["lit"] = counts.lit;
    json["shadowed"] = counts.shadowed;
    json["turnedAway"] = counts.turnedAway;
    json["ties"] = counts.ties;
    json["notJudged"] = judged.found.notJudged;
    json["falseLit"] = counts.falseLit;
    json["falseShadow"] = counts.falseShadow;
    json["coreErrors"] = judged.core;
    json["stray"] = counts.stray;
    json["edgeErrorPx"] = numberJson(judged.errors.edgeErrorPx);
    json["boundaryPx"] = displacementJson(judged.boundaryPx);
    json["rmse"] = counts.rmse;
    json["lightStrength"] = judged.found.strength;
    json["clipped"] = judged.found.clipped;
    json["white"] = judged.white ? Json(*judged.white) : Json(nullptr);
    json["remark"] = textJson(judged.remark);
    return json;
}

Json regionJson(const foreign::Region& region) {
    return {{"corner", {region.corner.x, region.corner.y}},
            {"size", {region.size.x, region.size.y}},
            {"wrong", region.pixels},
            {"falseLit", region.falseLit},
            {"falseShadow", region.falseShadow},
            {"coreErrors", region.core},
            {"firstWrong", {region.firstWrong.x, region.firstWrong.y}},
            {"object", textJson(region.object)}};
}

Json diagnosisJson(const JudgedPicture& judged) {
    Json causes = Json::array();
    for (const foreign::NamedCause& cause : judged.diagnosis.causes)
        causes.push_back({{"cause", cause.id}, {"beside", cause.beside == foreign::Beside::first ? "first" : cause.beside == foreign::Beside::also ? "also" : "instead"}, {"what", cause.what}, {"remedy", cause.remedy}, {"explained", cause.explained}, {"explainedInRegion", cause.explainedInRegion}});
    return causes;
}

Json encodingJson(const foreign::SeenEncoding& encoding) {
    return {{"curve", foreign::toText(encoding.curve)}, {"levels", encoding.levels}, {"levelsOfRightCurve", encoding.levelsOfRight}};
}

std::string numberText(const std::optional<double>& number, int decimals) { return number ? picture::fixed(*number, decimals) : "-"; }

const char* besideText(foreign::Beside beside) {
    return beside == foreign::Beside::first ? "looks" : beside == foreign::Beside::also ? "and also" : "or, less likely,";
}

std::string encodingText(const JudgeReport& report, const foreign::SeenEncoding& encoding) {
    const std::string which = report.reference.empty() ? "the penumbras are" : "the reference is";
    return which + " encoded with " + std::string(foreign::toText(encoding.curve)) + (report.reference.empty() ? ", not as it is" : ", not with sRGB") +
           ": so read, its pixels are " + picture::fixed(encoding.levels, 1) + " levels of 255 off in the middle, else " + picture::fixed(encoding.levelsOfRight, 1);
}

std::string calibrationText(const JudgeReport& report) {
    const Calibration& calibration = *report.calibration;
    std::string text;
    if (calibration.isRight()) {
        text = "calibration: right";
        if (calibration.shiftPx) text += " (shift " + picture::fixed(calibration.shiftPx->x, 2) + ", " + picture::fixed(calibration.shiftPx->y, 2) + " px; sRGB; exposure " + picture::fixed(calibration.exposure, 2) + ")";
        return text + "\n";
    }
    for (const foreign::FoundFault& fault : calibration.faults)
        text += "calibration: the picture " + fault.what + "\n  remedy: " + fault.remedy + "\n";
    return text + "Nothing is judged before this is right.\n";
}

std::string judgedText(const JudgeReport& report) {
    const JudgedPicture& judged = *report.judged;
    const judge::Counts& counts = judged.errors.judgement.counts;
    const auto& boundary = judged.boundaryPx;
    std::string text = aligned({{"truth: " + std::string(truthName(judged.truthOf)), "pixels", ""},
                                {"lit", std::to_string(counts.lit), ""},
                                {"in shadow", std::to_string(counts.shadowed), ""},
                                {"turned away", std::to_string(counts.turnedAway), ""},
                                {"ties", std::to_string(counts.ties), ""},
                                {"not judged", std::to_string(judged.found.notJudged), report.reference.empty() ? "" : "  the light adds too little, or the reference is white"},
                                {"with a surface", std::to_string(counts.pixels), ""}});
    text += "\n" + aligned({{"errors", "", ""},
                            {"false lit", std::to_string(counts.falseLit), ""},
                            {"false shadow", std::to_string(counts.falseShadow), ""},
                            {"core", std::to_string(judged.core), ""},
                            {"stray", std::to_string(counts.stray), ""},
                            {"edge error px", numberText(judged.errors.edgeErrorPx, 4), ""},
                            {"boundary px mean", boundary ? picture::fixed(boundary->mean, 3) : "-", ""},
                            {"boundary px p95", boundary ? picture::fixed(boundary->p95, 2) : "-", ""},
                            {"boundary px max", boundary ? picture::fixed(boundary->max, 2) : "-", ""},
                            {"RMSE", picture::fixed(counts.rmse, 4), ""}});
    if (const auto& region = judged.diagnosis.region) {
        text += "\nworst region: " + std::to_string(region->pixels) + (region->pixels == 1 ? " wrong pixel, " : " wrong pixels, ") + std::to_string(region->core) + (region->core == 1 ? " of them a core error, in " : " of them core errors, in ") +
                std::to_string(region->size.x) + "x" + std::to_string(region->size.y) + " at " + std::to_string(region->corner.x) + "," + std::to_string(region->corner.y);
        if (!region->object.empty()) text += ", most on '" + region->object + "'";
        text += "; first wrong pixel " + std::to_string(region->firstWrong.x) + "," + std::to_string(region->firstWrong.y) + "\n";
    }
    if (!judged.remark.empty()) text += "\nremark: " + judged.remark + ".\n";
    if (judged.white) text += "\nencoding: its white is " + std::to_string(*judged.white) + ", not 255; it is judged as if it were.\n  remedy: write 255 where the light is seen\n";
    if (judged.encoding) text += "\nencoding: " + encodingText(report, *judged.encoding) + ".\n";
    for (const foreign::NamedCause& cause : judged.diagnosis.causes)
        text += std::string(besideText(cause.beside)) + " like: " + cause.id + ": " + cause.what + ".\n  remedy: " + cause.remedy + "\n";
    if (counts.wrong() > 0 && judged.diagnosis.causes.empty()) text += "looks like: nothing that is known; no single cause explains a quarter of the wrong pixels.\n";
    if (judged.isRight()) text += "\nNo pixel is misjudged outside ties.\n";
    return text;
}

} // namespace

std::string judgeJson(const JudgeReport& report) {
    Json root;
    root["picture"] = report.picture;
    root["kind"] = report.reference.empty() ? "visibility" : "shaded";
    root["reference"] = textJson(report.reference);
    root["scene"] = report.scene;
    root["light"] = report.light;
    root["size"] = {report.size.x, report.size.y};
    root["calibration"] = report.calibration ? calibrationJson(*report.calibration) : Json(nullptr);
    root["judged"] = report.judged ? judgedJson(*report.judged) : Json(nullptr);
    root["encoding"] = nullptr;
    root["region"] = nullptr;
    root["causes"] = Json::array();
    if (report.judged) {
        if (report.judged->encoding) root["encoding"] = encodingJson(*report.judged->encoding);
        if (report.judged->diagnosis.region) root["region"] = regionJson(*report.judged->diagnosis.region);
        root["causes"] = diagnosisJson(*report.judged);
    }
    root["files"] = {{"errors", textJson(report.errorPicture)}, {"visibility", textJson(report.visibilityPicture)}, {"section", textJson(report.section)}};
    root["section"] = textJson(report.sectionCaption);
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string judgeText(const JudgeReport& report, std::optional<std::size_t> columns) {
    std::string text = report.picture + ": " + (report.reference.empty() ? "visibility" : "shaded, beside " + report.reference) + ", scene " + report.scene + ", light '" +
                       report.light + "', " + std::to_string(report.size.x) + "x" + std::to_string(report.size.y) + "\n";
    if (report.calibration) text += calibrationText(report);
    if (report.judged) text += "\n" + judgedText(report);
    for (const std::string& file : {report.errorPicture, report.visibilityPicture, report.section})
        if (!file.empty()) text += "written: " + file + "\n";
    if (!report.sectionCaption.empty()) text += "section: " + report.sectionCaption + "\n";
    if (!report.sectionRemark.empty()) text += "no section: " + report.sectionRemark + "\n";
    return fitting(text, columns);
}

} // namespace shadowlab::cli
