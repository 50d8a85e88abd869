// SPDX-License-Identifier: MIT
#include "app/report/store.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <functional>
#include <set>
#include <stdexcept>

#include "app/picture/digest.h"
#include "app/report/json_parts.h"
#include "app/report/part_file.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"

namespace shadowlab::report {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void failToRead(const fs::path& path) {
    throw Error(ExitStatus::badInput, path.string() + ": cannot be read; look at its permissions, or delete it");
}

[[noreturn]] void failAsChanged(const fs::path& picture) {
    throw Error(ExitStatus::badInput,
                picture.string() + ": is not the picture that was drawn here; run this part of the report again, "
                                   "which draws it anew");
}

[[noreturn]] void failAsForeign(const fs::path& path) {
    throw Error(ExitStatus::badInput, path.string() + ": is no part of a report that this program wrote; delete it");
}

/// None where there is no such file. One that cannot be read is an error; it is not overwritten.
std::optional<std::string> bytesOf(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return std::nullopt;
    return partBytes(file);
}

std::vector<std::uint8_t> pictureOf(const fs::path& file) {
    const std::string bytes = bytesOf(file).value_or("");
    return {bytes.begin(), bytes.end()};
}

/// What `read` makes of a file; none where there is no file.
template <typename Read>
auto readJson(const fs::path& file, const Read& read) -> std::optional<decltype(read(Json()))> {
    const std::optional<std::string> text = bytesOf(file);
    if (!text) return std::nullopt;
    if (!isText(*text)) failAsForeign(file);
    try {
        return read(Json::parse(*text));
    } catch (const Json::exception&) {
        failAsForeign(file);
    } catch (const std::domain_error&) {
        failAsForeign(file);
    }
}

void writeJson(const fs::path& file, const Json& json) {
    // A scene's name may hold bytes that are no UTF-8; JSON may not.
    image::writeWhole(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string endingOf(const Shard& shard) {
    return "-" + std::to_string(shard.number) + "-of-" + std::to_string(shard.count) + ".json";
}

std::array<std::string, 2> digestsOf(const Judge::Judged& judged) {
    return {picture::digestOf(judged.picturePng), picture::digestOf(judged.errorPng)};
}

} // namespace

std::string fileName(const std::string& name) {
    std::string safe;
    for (const char c : name) {
        const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                             std::string_view("-_=@.").find(c) != std::string_view::npos;
        safe += isPlain ? c : '_';
    }
    if (safe.starts_with('.')) safe.front() = '_';
    constexpr std::size_t kLongest = 120; // file systems take 255 bytes, endings included
    std::string blanksOnly = name;
    std::ranges::replace(blanksOnly, ' ', '_');
    const bool isClear = !name.empty() && name.find('_') == std::string::npos; // "a b" and "a_b" are two names
    if (isClear && safe == blanksOnly && safe.size() <= kLongest) return safe;
    return safe.substr(0, kLongest) + "-" + picture::digestOf(name);
}

fs::path Store::groupFolder(const PlannedGroup& group) const {
    return folder_ / "parts" / fileName(group.title + "@" + group.light);
}

void Store::begin(const Plan& plan) const {
    const fs::path file = folder_ / "plan.json";
    if (const auto before = readJson(file, planFromJson)) {
        if (*before != plan)
            throw Error(ExitStatus::badInput, file.string() + ": the report here is " + difference(*before, plan) +
                                                  "; choose another folder with -o, or delete this one");
    } else {
        for (const char* name : {"index.html", "report.json", "points.csv", "charts", "parts"})
            if (std::error_code absent; fs::exists(fs::symlink_status(folder_ / name, absent)))
                throw Error(ExitStatus::cannotWrite, (folder_ / name).string() +
                                                         ": is not of a report that was begun here, and would be "
                                                         "overwritten; choose another folder with -o");
        image::makeFolders(folder_);
        writeJson(file, toJson(plan)); // before the parts: a folder with parts alone is another's
    }
    for (const PlannedGroup& group : plan.groups)
        image::makeFolders(groupFolder(group));
}

Plan Store::plan() const {
    const fs::path file = folder_ / "plan.json";
    const auto plan = readJson(file, planFromJson);
    if (!plan)
        throw Error(ExitStatus::badInput,
                    file.string() +
                        ": no such file, so this folder holds no report; name folders that `report -o` made");
    return *plan;
}

fs::path Store::pointFile(const PlannedGroup& group, const PointKey& point) const {
    return groupFolder(group) / fileName(point.name());
}

std::optional<Store::Part> Store::part(const PlannedGroup& group, const PointKey& point) const {
    const fs::path base = pointFile(group, point);
    const auto part = readJson(base.string() + ".json", [](const Json& json) {
        return std::pair(errorsFromJson(json), json.at("pictures").get<std::array<std::string, 2>>());
    });
    if (!part) return std::nullopt;
    Judge::Judged judged{part->first, pictureOf(base.string() + ".png"), pictureOf(base.string() + "-errors.png")};
    const auto now = digestsOf(judged);
    return Part{std::move(judged), {now[0] == part->second[0], now[1] == part->second[1]}};
}

std::optional<Judge::Judged> Store::judged(const PlannedGroup& group, const PointKey& point) const {
    std::optional<Part> found = part(group, point);
    if (!found || !found->isWhole[0] || !found->isWhole[1]) return std::nullopt; // it has to be drawn again
    return std::move(found->judged);
}

void Store::keep(const PlannedGroup& group, const PointKey& point, const Judge::Judged& judged) const {
    const std::string base = pointFile(group, point).string();
    image::writeWhole(base + ".png", judged.picturePng);
    image::writeWhole(base + "-errors.png", judged.errorPng);
    Json part = toJson(judged.errors);
    part["pictures"] = digestsOf(judged);
    writeJson(base + ".json", part); // last: with it the point counts as known
}

Times Store::times(const PlannedGroup& group, const Shard& shard) const {
    return readJson(groupFolder(group) / ("times" + endingOf(shard)), timesFromJson).value_or(Times{});
}

void Store::keep(const PlannedGroup& group, const Shard& shard, const Times& times) const {
    writeJson(groupFolder(group) / ("times" + endingOf(shard)), toJson(times));
}

void Store::keep(const Shard& shard, const Machine& machine) const {
    writeJson(folder_ / "parts" / ("machine" + endingOf(shard)), toJson(machine));
}

std::vector<Shard> Store::shards() const {
    std::vector<Shard> shards;
    std::error_code error;
    fs::directory_iterator entries;
    do {
        entries = fs::directory_iterator(folder_ / "parts", error);
    } while (error.value() == EINTR); // on file systems of a network
    if (error) failToRead(folder_ / "parts");
    for (const fs::directory_entry& entry : entries) {
        Shard shard;
        int read = 0;
        const std::string name = entry.path().filename().string();
        const int values = std::sscanf(name.c_str(), "machine-%d-of-%d.json%n", &shard.number, &shard.count, &read);
        if (values == 2 && read == static_cast<int>(name.size())) shards.push_back(shard);
    }
    std::ranges::sort(shards, {}, [](const Shard& s) { return std::pair(s.count, s.number); });
    return shards;
}

Machine Store::machine(const Shard& shard) const {
    return readJson(folder_ / "parts" / ("machine" + endingOf(shard)), machineFromJson).value_or(Machine{});
}

void Store::readAll() const {
    for (const Shard& shard : shards())
        static_cast<void>(machine(shard));
    for (const PlannedGroup& group : plan().groups) {
        for (const PointKey& point : group.points) {
            const std::optional<Part> found = part(group, point);
            const std::string base = pointFile(group, point).string();
            if (found && !found->isWhole[0]) failAsChanged(base + ".png");
            if (found && !found->isWhole[1]) failAsChanged(base + "-errors.png");
        }
        for (const Shard& shard : shards())
            static_cast<void>(times(group, shard));
    }
}

void Store::takeOver(const Store& other) const {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(other.folder_ / "parts")) {
        if (!entry.is_regular_file() || entry.path().filename().string().starts_with('.'))
            continue; // a dot: half-written
        const fs::path relative = entry.path().lexically_relative(other.folder_), target = folder_ / relative;
        if (!fs::is_directory(target.parent_path())) continue; // of a group that is not in the plan
        const std::string bytes = bytesOf(entry.path()).value_or("");
        const bool isMeasured =
            relative.filename().string().starts_with("times-") || relative.filename().string().starts_with("machine-");
        if (const auto before = bytesOf(target); before && *before != bytes && !isMeasured)
            throw Error(ExitStatus::badInput, entry.path().string() +
                                                  ": another of the reports has this point with other results; merge "
                                                  "only reports of one program on one kind of machine");
        image::writeWhole(target, bytes);
    }
}

} // namespace shadowlab::report
