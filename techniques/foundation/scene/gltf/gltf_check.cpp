// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/gltf/gltf_schema.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

namespace {

using Kind = JsonValue::Kind;

/// Where a value stands, as in meshes[2].primitives[0].attributes; written out only when there is something to say.
struct Place {
    const Place* parent = nullptr;
    std::string_view key{};
    std::ptrdiff_t index = -1;

    [[nodiscard]] std::string text() const {
        std::string before = parent ? parent->text() : std::string();
        if (index >= 0) return before + "[" + std::to_string(index) + "]";
        if (!before.empty() && !key.empty()) before += '.';
        return before + shown(key, 40);
    }
};

/// An array that indices are into; nullptr where there is none. Lights are listed in an extension, all else at the top.
const JsonValue* gltfArray(const JsonValue& root, std::string_view array) {
    const JsonValue* found = &root;
    if (array == "lights")
        for (const std::string_view key : {"extensions", "KHR_lights_punctual"})
            found = found ? gltfMember(*found, key) : nullptr;
    return found ? gltfMember(*found, array) : nullptr;
}

/// Walks the file along the schema, and writes down what it finds right.
class GltfChecker {
public:
    GltfChecker(const JsonDocument& document, GltfNotes& notes) : document_(document), notes_(notes) {}

    std::string run() {
        const JsonValue& root = document_.root();
        const Place top{};
        if (root.kind != Kind::object)
            document_.fail(root.offset, "is " + std::string(describe(root.kind)) + ", and no glTF file; export the model as glTF 2.0");
        checkVersion(root);
        checkRequiredExtensions(root);
        writeObject(root, gltfSchema(), top);
        noteUnmetExtensions(root);
        return std::move(text_);
    }

private:
    [[noreturn]] void fail(const JsonValue& value, const Place& place, const std::string& message) const {
        document_.fail(value.offset, place.text() + " " + message);
    }

    void require(const JsonValue& value, const Place& place, Kind kind) const {
        if (value.kind != kind)
            fail(value, place, "is " + std::string(describe(value.kind)) + "; it must be " + std::string(describe(kind)));
    }

    void checkVersion(const JsonValue& root) const {
        const JsonValue* asset = gltfMember(root, "asset");
        const JsonValue* version = asset ? gltfMember(*asset, "version") : nullptr;
        if (!version || version->kind != Kind::string)
            document_.fail(asset ? asset->offset : root.offset,
                           "\"asset\" with its \"version\" is missing, as no glTF file may; is this one? Export the model as glTF 2.0");
        if (!version->string.starts_with("2."))
            document_.fail(version->offset,
                           "is of glTF version " + inQuotes(version->string) + ", and only 2.0 is read; export the model as glTF 2.0");
        // The version written may be newer than 2.0 and the file readable as 2.0 all the same, unless this says otherwise.
        const JsonValue* least = gltfMember(*asset, "minVersion");
        if (least && least->kind == Kind::string && least->string != "2.0" && !least->string.starts_with("1."))
            document_.fail(least->offset, "needs glTF version " + inQuotes(least->string) +
                                              " (minVersion), and only 2.0 is read; export the model as glTF 2.0");
    }

    void checkRequiredExtensions(const JsonValue& root) const {
        const JsonValue* required = gltfMember(root, "extensionsRequired");
        if (!required) return;
        const Place place{nullptr, "extensionsRequired"};
        require(*required, place, Kind::array);
        for (const JsonValue& name : required->items) {
            require(name, place, Kind::string);
            if (!isServedExtension(name.string))
                fail(name, place, "names " + inQuotes(name.string) + ", which this program does not have; export the model without it");
        }
    }

    /// What an extension of the list does may show nowhere as a key: as a kind of buffer, or as a value that the standard does not have.
    void noteUnmetExtensions(const JsonValue& root) {
        const JsonValue* used = gltfMember(root, "extensionsUsed");
        if (!used || used->kind != Kind::array) return;
        for (const JsonValue& name : used->items)
            if (name.kind == Kind::string && !isServedExtension(name.string) && !metExtensions_.contains(name.string))
                notes_.add("the extension " + inQuotes(name.string) + " is left out", "extensionsUsed", name.offset);
    }

    void writeObject(const JsonValue& value, std::span<const GltfKey> schema, const Place& place) {
        require(value, place, Kind::object);
        text_ += '{';
        bool isFirst = true;
        for (const JsonMember& member : value.members) {
            const auto key = std::ranges::find(schema, member.key, &GltfKey::name);
            const Place inside{&place, member.key};
            if (key == schema.end()) {
                if (member.key != "extras" && member.key != "extensions")
                    notes_.add("the unknown key " + inQuotes(member.key) + " is ignored", place.text(), member.keyOffset);
                continue;
            }
            if (!key->note.empty() && !isEmpty(member.value)) notes_.add(std::string(key->note), inside.text(), member.keyOffset);
            if (key->kind == GltfKey::Kind::ignored) continue;
            const std::size_t before = text_.size();
            text_ += isFirst ? "\"" : ",\"";
            text_.append(key->name).append("\":");
            writeValue(member.value, *key, inside);
            if (key->isPassedOn)
                isFirst = false;
            else
                text_.resize(before);
        }
        text_ += '}';
        for (const GltfKey& key : schema)
            if (key.isRequired && !gltfMember(value, key.name))
                fail(value, place, "has no " + inQuotes(key.name) + "; the file is not whole: export it again");
        checkDescription(value, place);
    }

    /// A camera and a spot light are described by an object that is named after their type.
    void checkDescription(const JsonValue& value, const Place& place) const {
        const bool isCamera = place.parent && place.parent->key == "cameras", isLight = place.parent && place.parent->key == "lights";
        if (!isCamera && !isLight) return;
        const JsonValue* type = gltfMember(value, "type");
        if (type && (isCamera || type->string == "spot") && !gltfMember(value, type->string))
            fail(value, place,
                 "is of type " + inQuotes(type->string) + " and has no " + inQuotes(type->string) +
                     " with its numbers; the file is not whole: export it again");
    }

    static bool isEmpty(const JsonValue& value) {
        return (value.kind == Kind::array && value.items.empty()) || (value.kind == Kind::object && value.members.empty());
    }

    void writeValue(const JsonValue& value, const GltfKey& key, const Place& place) {
        using enum GltfKey::Kind;
        switch (key.kind) {
        case flag:
            require(value, place, Kind::boolean);
            text_ += value.boolean ? "true" : "false";
            return;
        case number: return writeNumber(value, place);
        case share: return writeShares(value, key, place);
        case integer: return writeInteger(value, key, place);
        case text:
            require(value, place, Kind::string);
            checkAmong(value.string, key.of, value, place);
            text_ += key.name == "uri" ? "\"\"" : textInJson(value.string); // tinygltf sees none, and a data: URI may be long
            return;
        case reference: return writeReference(value, key.of, place);
        case references:
        case numbers:
        case objects: return writeArray(value, key, place);
        case object: return writeObject(value, key.schema, place);
        case attributes: return writeAttributes(value, key.of, place);
        case extensions: return writeExtensions(value, key.schema, place);
        case ignored: return;
        }
    }

    void writeNumber(double number) {
        std::array<char, 32> digits{};
        const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
        text_.append(digits.data(), end);
    }

    void writeNumber(const JsonValue& value, const Place& place) {
        require(value, place, Kind::number);
        writeNumber(value.number);
    }

    void writeShares(const JsonValue& value, const GltfKey& key, const Place& place) {
        const auto write = [&](const JsonValue& one) {
            require(one, place, Kind::number);
            const double clamped = std::clamp(one.number, key.least, key.most);
            if (clamped != one.number)
                notes_.add(inQuotes(key.name) + " is clamped to " + numberText(key.least) + " to " + numberText(key.most), place.text(),
                           one.offset);
            writeNumber(clamped);
        };
        if (key.count == 0) return write(value);
        requireLength(value, key.count, place);
        text_ += '[';
        for (std::size_t i = 0; i < value.items.size(); ++i)
            text_ += i > 0 ? "," : "", write(value.items[i]);
        text_ += ']';
    }

    void requireLength(const JsonValue& value, std::size_t count, const Place& place) const {
        require(value, place, Kind::array);
        if (value.items.size() != count)
            fail(value, place, "has " + counted(value.items.size(), "number") + "; it must have " + std::to_string(count));
    }

    /// Written as a whole number also where the file has 3.0, which tinygltf would take for none.
    void writeInteger(const JsonValue& value, const GltfKey& key, const Place& place) {
        require(value, place, Kind::number);
        const double most = std::min(key.most, 9007199254740991.0); // 2^53 - 1: up to here a double counts
        if (value.number != std::floor(value.number) || value.number < key.least || value.number > most)
            fail(value, place, "is " + numberText(value.number) + "; it must be a whole number" + rangeOf(key));
        if (std::fmod(value.number, key.multipleOf) != 0)
            fail(value, place, "is " + numberText(value.number) + "; it must be a multiple of " + std::to_string(key.multipleOf));
        const std::string digits = std::to_string(static_cast<std::int64_t>(value.number));
        checkAmong(digits, key.of, value, place);
        text_ += digits;
    }

    static std::string rangeOf(const GltfKey& key) {
        if (!std::isfinite(key.least)) return key.of.empty() ? "" : " among " + listOf(key.of);
        return key.most < 1e9 ? " from " + numberText(key.least) + " to " + numberText(key.most)
                              : " from " + numberText(key.least) + " on";
    }

    static std::string listOf(std::string_view allowed) {
        std::string list;
        for (const char c : allowed)
            list += c == '|' ? std::string(", ") : std::string(1, c);
        return list;
    }

    void checkAmong(std::string_view text, std::string_view allowed, const JsonValue& value, const Place& place) const {
        if (allowed.empty()) return;
        for (std::string_view rest = allowed; !rest.empty();) {
            const std::size_t end = std::min(rest.find('|'), rest.size());
            if (rest.substr(0, end) == text) return;
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        fail(value, place,
             "is " + (value.kind == Kind::string ? inQuotes(text) : std::string(text)) + "; it must be one of " + listOf(allowed));
    }

    void writeReference(const JsonValue& value, std::string_view array, const Place& place) {
        require(value, place, Kind::number);
        const std::size_t size = sizeOf(array);
        if (value.number != std::floor(value.number) || value.number < 0 || value.number >= static_cast<double>(size))
            fail(value, place,
                 "is " + numberText(value.number) + ", but the file has " + (size == 0 ? "no " : counted(size, "element") + " in ") +
                     inQuotes(array) + (size == 0 ? "" : ", counted from 0") + "; correct the index, or export the model again");
        text_ += std::to_string(static_cast<std::int64_t>(value.number));
    }

    [[nodiscard]] std::size_t sizeOf(std::string_view array) {
        const auto [entry, isNew] = sizes_.try_emplace(array, 0); // a file may have as many references as top-level keys
        if (isNew)
            if (const JsonValue* found = gltfArray(document_.root(), array)) entry->second = found->items.size();
        return entry->second;
    }

    void writeArray(const JsonValue& value, const GltfKey& key, const Place& place) {
        require(value, place, Kind::array);
        if (key.kind == GltfKey::Kind::numbers) requireLength(value, key.count, place);
        text_ += '[';
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            const Place element{&place, key.name, static_cast<std::ptrdiff_t>(i)};
            if (i > 0) text_ += ',';
            if (key.kind == GltfKey::Kind::objects)
                writeObject(value.items[i], key.schema, element);
            else if (key.kind == GltfKey::Kind::numbers)
                writeNumber(value.items[i], element);
            else
                writeReference(value.items[i], key.of, element);
        }
        text_ += ']';
    }

    void writeAttributes(const JsonValue& value, std::string_view array, const Place& place) {
        require(value, place, Kind::object);
        text_ += '{';
        for (std::size_t i = 0; i < value.members.size(); ++i) {
            const JsonMember& member = value.members[i];
            text_ += i > 0 ? "," : "";
            text_ += textInJson(member.key) + ":";
            writeReference(member.value, array, {&place, member.key});
        }
        text_ += '}';
    }

    void writeExtensions(const JsonValue& value, std::span<const GltfKey> known, const Place& place) {
        require(value, place, Kind::object);
        text_ += '{';
        bool isFirst = true;
        for (const JsonMember& member : value.members) {
            const auto key = std::ranges::find(known, member.key, &GltfKey::name);
            const Place inside{&place, member.key};
            metExtensions_.insert(member.key);
            if (key == known.end() || key->kind == GltfKey::Kind::ignored) {
                const bool hasNote = key != known.end() && !key->note.empty();
                notes_.add(hasNote ? std::string(key->note) : "the extension " + inQuotes(member.key) + " is left out",
                           place.parent ? place.parent->text() : std::string(), member.keyOffset);
                continue;
            }
            text_ += isFirst ? "" : ",";
            isFirst = false;
            text_ += textInJson(member.key) + ":";
            writeObject(member.value, key->schema, inside);
        }
        text_ += '}';
    }

    const JsonDocument& document_;
    GltfNotes& notes_;
    std::string text_;
    std::set<std::string_view> metExtensions_;
    std::map<std::string_view, std::size_t> sizes_; ///< of arrays that references are into
};

} // namespace

GltfSource::GltfSource(const JsonDocument& document) : document_(document) { text_ = GltfChecker(document, notes_).run(); }

const JsonValue* gltfMember(const JsonValue& object, std::string_view key) {
    const auto found = std::ranges::find(object.members, key, &JsonMember::key);
    return found == object.members.end() ? nullptr : &found->value;
}

std::string gltfElementName(std::string_view array, std::size_t index) { return std::string(array) + "[" + std::to_string(index) + "]"; }

const std::vector<JsonValue>& GltfSource::elements(std::string_view array) const {
    static const std::vector<JsonValue> none;
    const JsonValue* found = gltfArray(document_.root(), array);
    return found ? found->items : none;
}

void GltfSource::fail(std::string_view array, std::size_t index, const std::string& message, ExitStatus status) const {
    document_.fail(elements(array)[index].offset, gltfElementName(array, index) + " " + message, status);
}

void GltfSource::note(std::string_view array, std::size_t index, const std::string& what, std::uint64_t times) {
    notes_.add(what, gltfElementName(array, index), elements(array)[index].offset, times);
}

} // namespace shadowlab::scene
