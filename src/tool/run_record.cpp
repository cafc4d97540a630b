// SPDX-License-Identifier: Apache-2.0
#include "tool/run_record.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/format.h"
#include "base/read_file.h"
#include "jprim/base/error.h"

namespace jprim::tool {

using Json = nlohmann::ordered_json;

namespace {

constexpr int Format = 1;

std::string getPath(const std::string& folder) {
    return (std::filesystem::path(folder) / "run.json").string();
}

Json makeMessages(const RunLog& log) {
    Json messages = Json::array();
    for (const auto& [file, d] : log.messages)
        messages.push_back({{"file", file},
                            {"severity", d.severity == Severity::Error ? "error" : "warning"},
                            {"line", d.where.line},
                            {"column", d.where.column},
                            {"message", d.message}});
    return messages;
}

RunRecord readRecord(const Json& json) {
    RunRecord record;
    json.at("model").get_to(record.model);
    json.at("fingerprint").get_to(record.fingerprint);
    record.formulation =
        json.at("formulation") == "constraints" ? Formulation::Constraints : Formulation::Tree;
    json.at("options").get_to(record.options);
    json.at("summary").get_to(record.log.summary);
    if (!json.at("freedoms").is_null()) record.log.freedoms = json.at("freedoms").get<int>();
    for (const Json& m : json.at("messages"))
        record.log.messages.emplace_back(
            m.at("file"), Diagnostic{m.at("severity") == "error" ? Severity::Error : Severity::Warning,
                                     {m.at("line"), m.at("column")},
                                     m.at("message")});
    return record;
}

}  // namespace

// FNV-1a.
std::string makeFingerprint(const std::string& text) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return fmt::format("{:016x}", hash);
}

void saveRunRecord(const RunRecord& record, const std::string& folder) {
    const Json json = {
        {"format", Format},
        {"model", record.model},
        {"fingerprint", record.fingerprint},
        {"formulation", record.formulation == Formulation::Constraints ? "constraints" : "tree"},
        {"options", record.options},
        {"summary", record.log.summary},
        {"freedoms", record.log.freedoms ? Json(*record.log.freedoms) : Json(nullptr)},
        {"messages", makeMessages(record.log)}};
    std::ofstream stream(getPath(folder), std::ios::binary);
    stream << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    stream.close();
    if (!stream) throw Error(getPath(folder), "cannot be written");
}

RunRecord loadRunRecord(const std::string& folder) {
    const std::string path = getPath(folder);
    const std::optional<std::string> text = readFile(path);
    if (!text) throw Error(path, "cannot be read; a folder of results has it from `jprim run --out`");
    try {
        const Json json = Json::parse(*text);
        if (json.at("format") != Format) throw Error(path, "is of another version of jprim");
        return readRecord(json);
    } catch (const Json::exception& error) {
        throw Error(path, fmt::format("is not what a run writes: {}", error.what()));
    }
}

}  // namespace jprim::tool
