// SPDX-License-Identifier: MIT
#include "app/student/plugins.h"

#include <cxxabi.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <set>
#include <stdexcept>

#include "app/picture/derived_stages.h"
#include "app/student/plugin_file.h"
#include "app/student/plugin_trial.h"
#include "techniques/added_techniques.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/shader_source.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::student {

namespace {

using Fault = PluginFault;

std::vector<LoadedPlugin>& loaded() {
    static std::vector<LoadedPlugin> all;
    return all;
}

/// ", of FILE" where that folder is a plug-in's.
std::string ofPlugin(std::string_view folder) {
    const LoadedPlugin* const found = pluginOf(folder);
    return found ? ", of " + found->file : "";
}

/// "undefined symbol: _ZN9shadowlab..." with the name as it is written in C++.
std::string readable(std::string message) {
    const std::size_t at = message.find("_Z");
    if (at == std::string::npos) return message;
    const std::string name = message.substr(at, message.find_first_of(" ,()", at) - at);
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> text(abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status),
                                                      std::free);
    return status == 0 ? message.replace(at, name.size(), text.get()) : message;
}

/// The Plugin of a library that is loaded to stay. Throws Fault.
const Plugin& open(const std::filesystem::path& file) {
    const std::string path = std::filesystem::canonical(file).string(); // with a slash, or it is looked for elsewhere
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        std::string why = readable(::dlerror());
        if (why.starts_with(path + ": ")) why.erase(0, path.size() + 2);
        throw Fault("it cannot be loaded: " + why + "; build it again with the headers of this program");
    }
    const auto entry = reinterpret_cast<const Plugin* (*)()>(::dlsym(library, kPluginEntry));
    if (!entry) throw Fault(std::string("it has no function ") + kPluginEntry + "; build it with shadowlab_plugin()");
    const Plugin* const plugin = entry();
    if (!plugin || !plugin->techniques)
        throw Fault(std::string(kPluginEntry) + " gives nothing; build it with shadowlab_plugin()");
    return *plugin;
}

void requireGoodIds(const Plugin& plugin, const TechniqueInfo& info) {
    const std::string id = scene::shown(info.id); // a NUL byte would end the message
    if (!isKebabCase(info.id))
        throw Fault("'" + id + "' is no id of a technique; use small letters, digits, and hyphens between them");
    for (const RegisteredTechnique& other : registeredTechniques())
        if (other.info->id == info.id)
            throw Fault("there is a technique '" + id + "' already" + ofPlugin(other.folder) +
                        "; give this one another id");
    if (info.title.empty() || !info.make)
        throw Fault("technique '" + id + "' has no " + (info.make ? "title" : "function `make`") + "; give it one");
    const auto requireId = [&](std::string_view part, const char* what) {
        if (!isKebabCase(part))
            throw Fault("'" + scene::shown(part) + "' is no id of a " + what + " of '" + id +
                        "'; use small letters, digits, and hyphens between them");
    };
    for (const PassInfo& pass : info.passes)
        requireId(pass.id, "pass");
    for (const StageInfo& stage : info.stages) {
        requireId(stage.id, "stage");
        if (picture::isDerived(stage.id))
            throw Fault("the stage '" + std::string(stage.id) + "' of '" + id +
                        "' is one that the program makes itself; give it another id");
    }
    for (const gl::EmbeddedShader& shader : plugin.shaders)
        if (!shader.name.starts_with(std::string(plugin.folder) + "/"))
            throw Fault("its shader '" + scene::shown(shader.name) + "' is not in shaders/" +
                        scene::shown(plugin.folder) + "; move it there");
}

} // namespace

std::span<const TechniqueInfo> checkedTechniques(const Plugin& plugin) {
    const std::span<const TechniqueInfo> techniques = plugin.techniques();
    if (techniques.empty()) throw Fault("its techniques() lists none; list at least one");
    std::set<std::string_view> ids;
    for (const TechniqueInfo& info : techniques) {
        requireGoodIds(plugin, info);
        if (!ids.insert(info.id).second)
            throw Fault("it has two techniques '" + std::string(info.id) + "'; give one of them another id");
    }
    for (const RegisteredTechnique& other : registeredTechniques())
        if (other.folder == plugin.folder)
            throw Fault("there is a folder '" + std::string(plugin.folder) + "' already" + ofPlugin(other.folder) +
                        "; give the folder of shaders, and the namespace, another name");
    return techniques;
}

namespace {

/// All anchors that its passes name are there (techniques/source_text.h).
void requireAnchors(const Plugin& plugin, std::span<const TechniqueInfo> techniques) {
    SourceText source = SourceText::read();
    for (const EmbeddedSource& file : plugin.sources)
        source.add(std::string(file.name), file.text);
    for (const gl::EmbeddedShader& shader : plugin.shaders)
        source.add("shaders/" + std::string(shader.name), shader.text);
    for (const TechniqueInfo& info : techniques)
        for (const PassInfo& pass : info.passes)
            for (const AnchorUse& use : anchorsOf(pass))
                static_cast<void>(source.at(use.anchor)); // throws where there is none
}

} // namespace

bool isKebabCase(std::string_view id) {
    const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (id.empty() || !isLetter(id.front()) || id.back() == '-' || id.find("--") != std::string_view::npos)
        return false;
    return std::ranges::all_of(id, [&](char c) { return isLetter(c) || isDigit(c) || c == '-'; });
}

void loadPlugin(const std::filesystem::path& file) {
    requirePluginFile(file);
    const auto trial = [&] {
        const Plugin& plugin = open(file);
        const auto techniques = checkedTechniques(plugin);
        requireAnchors(plugin, techniques);
        for (const TechniqueInfo& info : techniques)
            if (const auto made = info.make(); !made || made->params().size() > 1000)
                throw Fault("make() of '" + std::string(info.id) + "' gives nothing; return a std::make_unique");
    };
    if (const auto fault = tryInChild(trial)) {
        const bool hasMend = fault->find("; ") != std::string::npos;
        refusePlugin(file, *fault + (hasMend ? ""
                                             : " while it is loaded; fix what runs before the first picture: static "
                                               "objects, techniques(), make()"));
    }
    const Plugin& plugin = open(file);
    const auto techniques = checkedTechniques(plugin);
    loaded().push_back({file.string(), &plugin, techniques});
    gl::addShaders(plugin.shaders, std::string(plugin.shaderFolder));
    addSources(plugin.sources);
    addTechniques(plugin.folder, techniques);
}

std::span<const LoadedPlugin> loadedPlugins() { return loaded(); }

const LoadedPlugin* pluginOf(std::string_view folder) {
    const auto found = std::ranges::find(loaded(), folder, [](const LoadedPlugin& one) { return one.plugin->folder; });
    return found == loaded().end() ? nullptr : &*found;
}

} // namespace shadowlab::student
