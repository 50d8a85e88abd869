// SPDX-License-Identifier: MIT
#include "app/hard/parts.h"

#include <algorithm>
#include <initializer_list>

#include "app/hard/results_json.h"
#include "app/picture/digest.h"
#include "app/report/part_file.h"
#include "app/report/store.h"
#include "app/student/program_digest.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::hard {

namespace {

namespace fs = std::filesystem;

/// Nothing where there is no such file, or none that can be read: what is made of it is no part of ours then.
std::string textOf(const fs::path& file) {
    return scene::whyUnreadable(file).empty() ? report::partBytes(file) : std::string();
}

Json jsonOf(const fs::path& file) {
    const std::string text = textOf(file);
    return report::isText(text) ? Json::parse(text, nullptr, false) : Json(Json::value_t::discarded);
}

bool isThere(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(file, ignored));
}

/// Is it a JSON object with all of these members?
bool holds(const fs::path& file, std::initializer_list<const char*> members) {
    const Json json = jsonOf(file);
    return std::ranges::all_of(members, [&](const char* member) { return json.contains(member); });
}

[[noreturn]] void failAsForeign(const fs::path& file) {
    throw Error(ExitStatus::cannotWrite, file.string() + ": is not of hard cases that were begun here, and would be "
                                                         "overwritten; choose another folder with -o");
}

} // namespace

Parts::Parts(fs::path folder, std::string madeBy, std::span<const Case> cases)
    : folder_(std::move(folder)), madeBy_(std::move(madeBy)) {
    for (const Case& one : cases)
        if (const fs::path part = fileOf(one); isThere(part) && !holds(part, {"madeFrom", "pictures", "result"}))
            failAsForeign(part);
    const bool isOurs = holds(folder_ / "hard.json", {"renderer", "cases"}); // written first of the four
    for (const char* name : {"hard.json", "hard.csv", "hard-matrix.csv", "hard.html"})
        if (isThere(folder_ / name) && !isOurs) failAsForeign(folder_ / name);
    image::makeFolders(folder_ / "parts");
    image::makeFolders(folder_ / "pictures");
}

fs::path Parts::fileOf(const Case& one) const { return folder_ / "parts" / (report::fileName(one.id) + ".json"); }

std::string Parts::madeFrom(const Case& one) const {
    std::string text = madeBy_ + "\n" + textOf(one.file);
    if (one.picture) text += picture::digestOf(*one.picture->scene);
    for (const Check& check : one.checks) {
        text += " " + picture::digestOf(*check.right.scene);
        for (const Expectation& expected : check.expectations)
            if (expected.from) text += " " + picture::digestOf(*expected.from->scene);
    }
    return text;
}

std::optional<CaseResult> Parts::find(const Case& one) const {
    if (!isThere(fileOf(one))) return std::nullopt;
    try {
        const Json part = jsonOf(fileOf(one));
        if (part.at("madeFrom") != madeFrom(one)) return std::nullopt;
        for (const auto& [picture, digest] : part.at("pictures").items())
            if (picture::digestOf(textOf(folder_ / "pictures" / picture)) != digest.get<std::string>())
                return std::nullopt;
        return caseResultFromJson(part.at("result"));
    } catch (const Json::exception&) {
        return std::nullopt; // nothing is lost but the time to run the case again
    }
}

void Parts::keep(const Case& one, const CaseResult& result) const {
    Json digests = Json::object();
    const auto write = [&](const Pictures& pictures) {
        if (pictures.name.empty()) return;
        for (const auto& [ending, png] :
             {std::pair(".png", &pictures.picturePng), {"-errors.png", &pictures.errorPng}}) {
            image::writeWhole(folder_ / "pictures" / (pictures.name + ending), *png);
            digests[pictures.name + ending] = picture::digestOf(*png);
        }
    };
    for (const Row& row : result.rows) {
        write(row.right);
        if (row.naive) write(*row.naive);
    }
    for (const Cell& cell : result.cells)
        write(cell.pictures);
    // Last: with it the case counts as known.
    const Json part{{"madeFrom", madeFrom(one)}, {"pictures", digests}, {"result", toJson(result)}};
    image::writeWhole(fileOf(one), part.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void Parts::discard(std::span<const Case> cases) const {
    std::error_code ignored; // what stays is found to be old, or used again: neither does harm
    for (const Case& one : cases)
        fs::remove(fileOf(one), ignored);
    fs::remove(folder_ / "parts", ignored); // not where a report has its parts there
}

std::string madeBy(const std::string& renderer, bool small, std::span<const Column> columns) {
    std::string text = student::programDigest() + ", " + renderer + (small ? ", small" : ", full size");
    for (const Column& column : columns)
        text += ", " + column.title();
    return text;
}

} // namespace shadowlab::hard
