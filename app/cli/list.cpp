// `shadowlab list`: tables of techniques, scenes, lessons and so on, made from the techniques and the folders themselves.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <sstream>

#include <glad/gl.h>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/json/json_values.h"
#include "app/cli/messages.h"
#include "app/cli/text_table.h"
#include "app/context/assets.h"
#include "app/course/deck.h"
#include "app/course/lessons/lesson.h"
#include "app/course/lessons/lesson_quantities.h"
#include "app/figures/figures.h"
#include "app/film/path.h"
#include "app/picture/derived_stages.h"
#include "app/picture/limits.h"
#include "app/picture/stage_ref.h"
#include "app/student/plugins.h"
#include "app/student/skeletons.h"
#include "app/window/actions.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/registry.h"
#include "techniques/source_text.h"

namespace shadowlab::cli {

namespace {

struct ListOptions {
    std::string what;
    bool json = false;
};

void describeList(DescribedOptions& add) {
    add.option("WHAT", "", "which list (default: the lists that there are, and how long they are)");
    add.flag("--json", "one JSON object instead of lines");
    add.footer(
        "On a terminal the columns are aligned and have headings; in a pipe or a file they are lines with tabs between "
        "them.\n"
        "Examples:\n"
        "  shadowlab list\n"
        "  shadowlab list techniques\n"
        "  shadowlab list parameters --json\n"
        "  shadowlab list limits | cut -f 1,2");
}

ListOptions listOptions(const GivenOptions& given) { return {given.text("WHAT"), given.has("--json")}; }

/// A list: one row a thing, each with the same named columns. Rows become tab-separated lines or JSON objects.
struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// Where it comes from: a folder of the project, or the file of a plug-in.
std::string placeOf(const RegisteredTechnique& technique) {
    const student::LoadedPlugin* const plugin = student::pluginOf(technique.folder);
    return plugin ? plugin->file : "techniques/" + std::string(technique.folder);
}

Table techniquesTable() {
    Table table{{"id", "title", "paper", "getsWrong", "folder", "group", "sister"}, {}};
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const TechniqueInfo& info = *technique.info;
        table.rows.push_back({std::string(info.id), std::string(info.title), std::string(info.paper),
                              std::string(info.getsWrong), placeOf(technique), std::string(toText(info.group)),
                              std::string(info.sister)});
    }
    return table;
}

Table pluginsTable() {
    Table table{{"file", "technique", "family", "skeleton"}, {}};
    for (const student::LoadedPlugin& plugin : student::loadedPlugins())
        for (const TechniqueInfo& info : plugin.techniques)
            table.rows.push_back({plugin.file, std::string(info.id), std::string(plugin.plugin->family),
                                  student::skeletonOf(*plugin.plugin)});
    return table;
}

Table parametersTable() {
    Table table{{"parameter", "default", "range", "unit", "help", "basic", "group", "label", "choices"}, {}};
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const std::unique_ptr<Technique> instance = technique.info->make();
        const params::ParamList list = instance->params();
        for (const params::ParamGroup& group : params::grouped(list)) // in the order of the panel
            for (const params::Param* param : group.params)
                table.rows.push_back({std::string(technique.info->id) + "." + param->id, params::initialText(*param),
                                      params::rangeText(*param), param->unit, param->help,
                                      params::isBasic(*param) ? "true" : "false", param->group, params::labelOf(*param),
                                      params::choicesText(*param)});
    }
    return table;
}

/// Lines of pseudocode as one line of a list.
std::string inOneLine(std::string_view lines) {
    std::string line;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i] == '\n') {
            line += "; ";
            while (i + 1 < lines.size() && lines[i + 1] == ' ')
                ++i;
        } else {
            line += lines[i];
        }
    }
    return line;
}

Table stagesTable() {
    Table table{{"technique", "stage", "perLight", "caption", "why", "pseudocode", "glState", "derived"}, {}};
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const std::string id(technique.info->id);
        for (const StageInfo& stage : picture::stagesOf(*technique.info))
            table.rows.push_back({id, std::string(stage.id), stage.perLight ? "true" : "false",
                                  std::string(stage.caption), "", "", "",
                                  picture::isDerived(stage.id) ? "true" : "false"});
        for (const PassInfo& pass : technique.info->passes)
            table.rows.push_back({id, picture::StageRef{std::string(pass.id), {}, true}.text(),
                                  pass.perLight ? "true" : "false", std::string(pass.title), std::string(pass.why),
                                  inOneLine(pseudocodeOf(*technique.info, pass)), std::string(pass.glState), "false"});
    }
    return table;
}

/// Where in the source each step is: every anchor of every pass.
Table sourceTable() {
    Table table{{"technique", "pass", "file", "lines", "anchor", "onlyIf"}, {}};
    const SourceText source = SourceText::read();
    for (const RegisteredTechnique& technique : registeredTechniques())
        for (const PassInfo& pass : technique.info->passes)
            for (const AnchorUse& use : anchorsOf(pass)) {
                const Snippet& snippet = source.at(use.anchor);
                table.rows.push_back({std::string(technique.info->id), std::string(pass.id), snippet.file,
                                      std::to_string(snippet.lines.first) + "-" + std::to_string(snippet.lines.last),
                                      use.anchor, use.parameter.empty() ? "" : use.parameter + "=" + use.value});
            }
    return table;
}

Table figuresTable() {
    Table table{{"name", "techniques", "shows"}, {}};
    for (const figures::Figure& figure : figures::figures())
        table.rows.push_back({std::string(figure.name), std::string(figure.techniques), std::string(figure.shows)});
    return table;
}

Table decksTable() {
    const scene::LoadOptions loading = loadOptions({});
    Table table{{"name", "title", "slides"}, {}};
    for (const std::string& name : course::builtInDecks(loading.assetsRoot)) {
        const course::Deck deck(name, loading);
        table.rows.push_back({name, deck.title(), std::to_string(deck.slides().size())});
    }
    return table;
}

Table lessonsTable() {
    Table table{{"name", "chapter", "title", "happens", "mends"}, {}};
    for (const course::LessonText& lesson : course::builtInLessons(context::assetsRoot()))
        table.rows.push_back({lesson.name, lesson.chapter, lesson.title, lesson.happens, lesson.remedy});
    return table;
}

Table quantitiesTable() {
    Table table{{"quantity", "unit", "help"}, {}};
    for (const course::LessonQuantity& quantity : course::lessonQuantities())
        table.rows.push_back({std::string(quantity.id), std::string(quantity.unit), std::string(quantity.help)});
    return table;
}

/// What a scene's file says first: the comment that it begins with, to the first blank line of it.
std::string firstComment(const std::filesystem::path& file) {
    std::string words;
    std::istringstream lines(scene::readFile(file, scene::Limits{}.sceneFileBytes));
    for (std::string line; std::getline(lines, line) && line.starts_with("// ");)
        words += (words.empty() ? "" : " ") + line.substr(3);
    return words;
}

Table scenesTable() {
    Table table{{"name", "about"}, {}};
    const std::filesystem::path assets = context::assetsRoot();
    for (const std::string& name : scene::builtInScenes(assets))
        table.rows.push_back({name, firstComment(assets / "scenes" / (name + ".json"))});
    return table;
}

Table backendsTable() {
    Table table{{"name", "available", "version", "renderer", "reason", "mend"}, {}};
    for (const context::BackendReport& report : context::probeBackends())
        table.rows.push_back({report.name, report.available ? "true" : "false", report.version, report.renderer,
                              report.reason, report.remedy});
    return table;
}

struct DriverLimit {
    const char* name;
    GLenum which;
    const char* unit;
};
constexpr std::array kDriverLimits{
    DriverLimit{"driver-texture-side", GL_MAX_TEXTURE_SIZE, "texels"},
    DriverLimit{"driver-texture-layers", GL_MAX_ARRAY_TEXTURE_LAYERS, "layers"},
    DriverLimit{"driver-buffer-texture", GL_MAX_TEXTURE_BUFFER_SIZE, "texels"},
    DriverLimit{"driver-sub-pixel", GL_SUBPIXEL_BITS, "bits"},
};

/// What the driver of the default context can hold; nothing, with a note, on a machine without graphics.
void addDriverLimits(Table& table) {
    try {
        const std::unique_ptr<context::Context> context = context::createContext(context::Backend::automatic);
        for (const DriverLimit& limit : kDriverLimits) {
            GLint value = 0;
            glGetIntegerv(limit.which, &value);
            table.rows.push_back({limit.name, std::to_string(value), limit.unit});
        }
    } catch (const Error& why) {
        note(std::string("the limits of the graphics driver are not known: ") + why.what());
    }
}

Table keysTable() {
    Table table{{"action", "group", "keys", "help"}, {}};
    for (const window::Action& action : window::actions())
        table.rows.push_back({action.id, action.group, action.keys, action.help});
    return table;
}

Table limitsTable() {
    Table table{{"limit", "value", "unit"}, {}};
    for (const picture::NamedLimit& limit : picture::namedLimits())
        table.rows.push_back({limit.name, std::to_string(limit.value()), limit.unit});
    addDriverLimits(table);
    return table;
}

std::string lines(const Table& table) {
    std::string text;
    for (const std::vector<std::string>& row : table.rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            text += row[i] + (i + 1 < row.size() ? '\t' : '\n');
    return text;
}

std::string tableJson(const std::string& what, const Table& table) {
    Json entries = Json::array();
    for (const std::vector<std::string>& row : table.rows) {
        Json entry;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool boolean = table.columns[i] == "available" || table.columns[i] == "perLight" ||
                                 table.columns[i] == "derived" || table.columns[i] == "basic";
            if (boolean)
                entry[table.columns[i]] = row[i] == "true";
            else
                entry[table.columns[i]] = row[i];
        }
        entries.push_back(std::move(entry));
    }
    return Json{{what, entries}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// A list by its name, and what is in it.
struct NamedTable {
    const char *name, *about;
    Table (*make)();
    std::size_t (*length)() = nullptr; ///< of a table for which a graphics driver is asked, which takes its time
};

constexpr std::array kTables{
    NamedTable{"techniques", "ways to draw shadows, for -t", techniquesTable},
    NamedTable{"parameters", "their settings, for --set, with what each may be", parametersTable},
    NamedTable{"stages", "intermediate pictures and passes, for --stage", stagesTable},
    NamedTable{"source", "where in the source each pass is", sourceTable},
    NamedTable{"scenes", "built-in scenes", scenesTable},
    NamedTable{"figures", "the lectures' figures of a pixel, for probe --figure", figuresTable},
    NamedTable{"decks", "slides, for slides and demo --deck", decksTable},
    NamedTable{"lessons", "artefacts and their remedies, for lesson and demo --lesson", lessonsTable},
    NamedTable{"quantities", "what lessons measure", quantitiesTable},
    NamedTable{"keys", "of the window", keysTable},
    NamedTable{"plugins", "techniques of --plugin", pluginsTable},
    NamedTable{"backends", "where OpenGL can come from, for --backend", backendsTable,
               [] { return static_cast<std::size_t>(context::Backend::window); }}, // the last; the first, automatic, is none of its own
    NamedTable{"limits", "of sizes and memory, for --limit", limitsTable,
               [] { return picture::namedLimits().size() + kDriverLimits.size(); }},
};

Table overviewTable() {
    Table table{{"list", "entries", "what"}, {}};
    for (const NamedTable& one : kTables)
        table.rows.push_back({one.name, std::to_string(one.length ? one.length() : one.make().rows.size()), one.about});
    return table;
}

/// Lines with tabs for programs, and columns for people.
std::string forReader(const Table& table) {
    const std::optional<std::size_t> columns = terminalColumns();
    return columns ? listed(table.columns, table.rows, *columns) : lines(table);
}

/// "filters": a parameter, or the values of one. Empty where nothing is called so.
std::string whereElse(const std::string& word) {
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        if (word == technique.info->id) return "that is a technique: see shadowlab list techniques";
        for (const params::Param& param : technique.info->make()->params())
            if (word == param.id || word == param.id + "s" || word == param.id + "es")
                return "that is parameter " + std::string(technique.info->id) + "." + param.id +
                       ": see shadowlab list parameters";
    }
    return "";
}

int list(const ListOptions& options) {
    std::vector<std::string> known;
    for (const NamedTable& one : kTables)
        known.emplace_back(one.name);
    const auto found = std::ranges::find(known, options.what);
    if (found == known.end() && !options.what.empty()) {
        const std::string elsewhere = whereElse(options.what);
        throw Error(ExitStatus::usage, "list: no list is called '" + options.what + "'; " +
                                           (elsewhere.empty() ? suggestion(options.what, known) : elsewhere));
    }
    const bool isOverview = options.what.empty();
    const Table table = isOverview ? overviewTable() : kTables[static_cast<std::size_t>(found - known.begin())].make();
    print(options.json ? tableJson(isOverview ? "lists" : options.what, table) : forReader(table));
    if (isOverview && !options.json && terminalColumns()) print("\nshadowlab list NAME prints one of them.\n");
    return 0;
}

Work listWork(const GivenOptions& given) {
    return [options = listOptions(given)] { return list(options); };
}

} // namespace

const Command kList{"list", "[WHAT]",
                    "What there is: techniques, parameters, stages, scenes, keys of the window, backends, limits",
                    describeList, listWork};

} // namespace shadowlab::cli
