// SPDX-License-Identifier: Apache-2.0
#include "jprim/report/write_report.h"

#include <algorithm>

#include "base/format.h"
#include "jprim/dataset/write_dataset.h"
#include "jprim/version.h"
#include "report/describe.h"
#include "report/page.h"
#include "report/unit_names.h"

namespace jprim {

namespace {

// Of numbers, before base64 makes them a third longer: with the page it is a file that can still be mailed and opened.
constexpr size_t MostBytes = 43'000'000;
constexpr size_t MostBytesOfPoses = 30'000'000;

Json makeUnits(const Dataset& dataset) {
    const UnitNames units = findUnitNames(dataset);
    return {{"length", units.length}, {"force", units.force}, {"mass", units.mass}, {"time", units.time}};
}

std::string getSimbodyVersion() {
    int major = 0, minor = 0, build = 0;
    SimTK_version_simbody(&major, &minor, &build);
    return fmt::format("{}.{}.{}", major, minor, build);
}

Json makeWarnings(const ReportNotes& notes) {
    Json warnings = Json::array();
    for (const auto& [file, d] : notes.warnings)
        warnings.push_back(
            {{"severity", d.severity == Severity::Error ? "error" : "warning"},
             {"where",
              d.where.line == 0 ? file : fmt::format("{}:{}:{}", file, d.where.line, d.where.column)},
             {"message", d.message}});
    return warnings;
}

Json makeText(const Dataset& dataset, const ReportNotes& notes) {
    return {{"dataset", notes.datasetText.empty() ? writeDataset(dataset) : notes.datasetText},
            {"file", notes.file},
            {"options", notes.options},
            {"versions", Json::array({{"jprim", JPRIM_VERSION}, {"Simbody", getSimbodyVersion()}})},
            {"summary", notes.summary},
            {"analysis", notes.analysis},
            {"warnings", makeWarnings(notes)},
            {"freedoms", notes.freedoms ? Json(*notes.freedoms) : Json(nullptr)}};
}

// Every how many rows of the results make a frame.
size_t chooseStride(const Mechanism& mechanism, const Motion& motion) {
    size_t numbers = 7 * mechanism.getParts().size();
    for (const MechanismPart& part : mechanism.getParts())
        if (part.flexible) numbers += size_t(part.flexible->getNumModes());
    return 1 + motion.getNumFrames() * numbers * sizeof(float) / MostBytesOfPoses;
}

Json makeFrames(const Mechanism& mechanism, const Motion& motion, size_t stride, ReportData& data) {
    const size_t parts = mechanism.getParts().size();
    std::vector<double> times;
    std::vector<float> poses;
    for (size_t frame = 0; frame < motion.getNumFrames(); frame += stride) {
        times.push_back(motion.getTime(frame));
        for (size_t part = 0; part < parts; ++part) appendPose(motion.calcPose(frame, part), poses);
    }
    return {{"time", data.addArray(times, {times.size()})},
            {"poses", data.addArray(poses, {times.size(), parts, 7})}};
}

std::string getTitle(const Dataset& dataset, const ReportNotes& notes) {
    const std::string& title = dataset.title;
    return title.find_first_not_of(" \t!") == title.npos ? notes.file : title;
}

}  // namespace

bool canWriteReports() {
    return !getReportPage().empty();
}

void writeReport(const Dataset& dataset, const Mechanism& mechanism, const Results& results,
                 const std::string& path, const ReportNotes& notes) {
    const Motion motion(mechanism, results);
    ReportData data;
    Json& json = data.json;
    json = {{"format", 1}, {"title", getTitle(dataset, notes)}, {"units", makeUnits(dataset)}};
    json["text"] = makeText(dataset, notes);
    describeMechanism(dataset, mechanism, motion, results, json);
    json["graphics"] = describeGraphics(dataset, mechanism, motion);
    const size_t stride = chooseStride(mechanism, motion);
    json["flexible"] = describeFlexible(mechanism, motion, stride, data);
    json["frames"] = makeFrames(mechanism, motion, stride, data);
    std::vector<std::string> omitted;
    const size_t used = data.getNumBytes();
    json["tables"] =
        describeTables(dataset, mechanism, results, MostBytes - std::min(MostBytes, used), data, omitted);
    if (stride > 1)
        omitted.push_back(fmt::format("of the motion all but every {}th row: see parts.csv", stride));
    for (const std::string& what : omitted)
        json["text"]["warnings"].push_back({{"severity", "warning"},
                                            {"where", ""},
                                            {"message", "left out to keep this file small: " + what}});
    data.write(path);
}

}  // namespace jprim
