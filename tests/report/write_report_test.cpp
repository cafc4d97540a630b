// SPDX-License-Identifier: Apache-2.0
// What a browser reads in a report is what was recorded.
#include "jprim/report/write_report.h"

#include <unistd.h>

#include <filesystem>

#include "jprim/flexible/reduce_to_modes.h"
#include "report/describe.h"
#include "report/report_reader.h"
#include "support/expect_error.h"
#include "support/run_dataset.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using testing::ReportReader;

/// A dataset that has been run, and its report.
class Reported {
public:
    explicit Reported(const std::string& text, const ReportNotes& notes = {}, double end = 1, int steps = 20)
        : dataset(read(text)), mechanism(testing::buildOrFail(text)) {
        if (!canWriteReports()) return;
        results = testing::run(mechanism, end, steps, 1e-6).results;
        const std::string path = (std::filesystem::temp_directory_path() /
                                  ("jprim_report_test_" + std::to_string(getpid()) + ".html"))
                                     .string();
        writeReport(dataset, mechanism, results, path, notes);
        report = std::make_unique<ReportReader>(path);
        std::filesystem::remove(path);
    }

    static Dataset read(const std::string& text) {
        Diagnostics diagnostics;
        return readDataset(text, diagnostics);
    }

    Dataset dataset;
    Mechanism mechanism;
    Results results;
    std::unique_ptr<ReportReader> report;
};

#define REQUIRE_PAGE(reported) \
    if (!(reported).report) GTEST_SKIP() << "jprim was built without the page of reports"

// A double pendulum in millimetres; of the first arm the CM marker is turned, the second has a body coordinate system
// elsewhere.
const char* const Pendulum =
    "double pendulum\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\nACCGRAV/JGRAV=-9806.65\n"
    "PART/1,GROUND\nMARKER/10\n"
    "PART/2,MASS=2,CM=20,IP=100,200,300\nMARKER/20,QP=50,0,0,REULER=0.1,0.2,0.3\nMARKER/21\nMARKER/22,QP=100,0,0\n"
    "PART/3,QG=100,0,0,REULER=0.5,0,0,MASS=1,CM=30,IM=31,IP=100,3000,3000,1,2,3\nMARKER/30,QP=40,0,0\nMARKER/31\n"
    "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\nREQUEST/1,DISPLACEMENT,I=30\n"
    "SPRINGDAMPER/1,TRANSLATION,I=30,J=10,K=0.1\n";

TEST(Report, FramesAreWherePartsWere) {
    const Reported r(Pendulum);
    REQUIRE_PAGE(r);
    const auto& json = r.report->json;
    const std::vector<double> times = r.report->read(json["frames"]["time"]),
                              poses = r.report->read(json["frames"]["poses"]);
    EXPECT_EQ(times, r.results.parts.getColumn("time"));
    ASSERT_EQ(poses.size(), 21u * 3 * 7);
    // The CM marker's place on the part, from the dataset, must lead to what parts.csv says.
    const SimTK::Transform X_BC[] = {
        {}, {SimTK::Rotation(), SimTK::Vec3(50, 0, 0)}, {SimTK::Rotation(), SimTK::Vec3(40, 0, 0)}};
    for (size_t row = 0; row < 21; ++row)
        for (size_t part = 1; part < 3; ++part) {
            const double* const p = poses.data() + (row * 3 + part) * 7;
            const SimTK::Rotation R(SimTK::Quaternion(SimTK::Vec4(p[3], p[4], p[5], p[6])));
            const SimTK::Vec3 cm = SimTK::Transform(R, SimTK::Vec3(p[0], p[1], p[2])) * X_BC[part].p();
            const std::string name = part == 1 ? "PART/2." : "PART/3.";
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(cm[k], r.results.parts.getColumn(name + "XYZ"[k])[row], 1e-4) << name << row;
        }
}

TEST(Report, TablesHaveEveryDigit) {
    const Reported r(Pendulum);
    REQUIRE_PAGE(r);
    const std::pair<const char*, const Table*> tables[] = {{"requests", &r.results.requests},
                                                           {"reactions", &r.results.reactions},
                                                           {"parts", &r.results.parts},
                                                           {"energy", &r.results.parts}};
    for (const auto& [name, table] : tables) {
        const auto written = r.report->findTable(name);
        ASSERT_FALSE(written.is_null()) << name;
        const std::vector<double> data = r.report->read(written["data"]);
        const size_t rows = table->getNumRows();
        EXPECT_EQ(r.report->read(written["time"]), table->getColumn("time"));
        for (size_t k = 0; k < written["columns"].size(); ++k)
            EXPECT_EQ(std::vector<double>(data.begin() + std::ptrdiff_t(k * rows),
                                          data.begin() + std::ptrdiff_t((k + 1) * rows)),
                      table->getColumn(written["columns"][k]["name"]));
    }
    const auto requests = r.report->findTable("requests")["columns"];
    EXPECT_EQ(requests[0]["name"], "R1.MAG");
    EXPECT_EQ(requests[0]["unit"], "mm");
    EXPECT_EQ(requests[0]["element"], "REQUEST/1");
    EXPECT_EQ(requests[6]["unit"], "rad");
    EXPECT_EQ(r.report->findTable("reactions")["columns"][3]["unit"], "N mm");
    EXPECT_EQ(r.report->findTable("energy")["columns"].size(), 5u);
}

TEST(Report, TheModelIsTheDatasets) {
    const Reported r(Pendulum);
    REQUIRE_PAGE(r);
    const auto& json = r.report->json;
    EXPECT_EQ(json["title"], "double pendulum");
    EXPECT_EQ(json["units"].dump(), R"({"force":"N","length":"mm","mass":"kg","time":"s"})");
    EXPECT_NEAR(json["gravity"][1].get<double>(), -9806.65, 1e-9);
    ASSERT_EQ(json["parts"].size(), 3u);
    EXPECT_EQ(json["parts"][0]["ground"], true);
    EXPECT_EQ(json["parts"][2]["parent"], "PART/2");
    EXPECT_EQ(json["parts"][2]["joint"], "Pin: JOINT/2");
    EXPECT_NEAR(json["parts"][2]["mass"].get<double>(), 1, 1e-12);
    // About the mass centre; products keep the sign that Adams gives them.
    const double inertia[] = {100, 3000 - 1600, 3000 - 1600, 1, 2, 3};
    for (size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(json["parts"][2]["inertia"][k].get<double>(), inertia[k], 1e-9) << k;
    EXPECT_EQ(json["markers"][3]["id"], 22);
    EXPECT_EQ(json["markers"][3]["part"], 1);
    EXPECT_NEAR(json["markers"][3]["pose"][0].get<double>(), 100, 1e-9);
    EXPECT_EQ(json["elements"][0]["id"], "JOINT/1");
    EXPECT_EQ(json["elements"][0]["type"], "REVOLUTE");
    EXPECT_EQ(json["elements"][1]["i"], 31);
    EXPECT_EQ(json["elements"][1]["j"], 22);
    const size_t first = json["elements"][1]["loadOnI"];
    EXPECT_EQ(r.report->findTable("reactions")["columns"][first]["name"], "JOINT/2.I.FX");
    EXPECT_EQ(json["elements"][2]["id"], "SPRINGDAMPER/1");
    EXPECT_EQ(json["elements"][2]["isForce"], true);
    EXPECT_TRUE(json["elements"][2]["loadOnI"].is_null());
}

TEST(Report, GraphicsThatAreDrawn) {
    const Reported r(
        std::string(Pendulum) +
        "GRAPHICS/1,CYLINDER,CM=20,LENGTH=5,RADIUS=2\nGRAPHICS/2,BOX,CORNER=20,X=1,Y=2,Z=3\n"
        "GRAPHICS/3,CIRCLE,CM=21,RM=22\nGRAPHICS/4,OUTLINE=10,21,22\nGRAPHICS/5,SPDP,I=30,J=10,COILS=7,DA=4\n"
        "GRAPHICS/6,POINT,RM=10\nGRAPHICS/7,ARC,CM=21,RADIUS=1,RANGLE=90D\n");
    REQUIRE_PAGE(r);
    const auto& graphics = r.report->json["graphics"];
    ASSERT_EQ(graphics.size(), 6u);
    EXPECT_EQ(graphics[0].dump(),
              R"({"id":"GRAPHICS/1","marker":20,"shape":"CYLINDER","values":{"length":5.0,"radius":2.0}})");
    EXPECT_EQ(graphics[1]["marker"], 20);
    EXPECT_EQ(graphics[1]["values"].dump(), R"({"x":1.0,"y":2.0,"z":3.0})");
    EXPECT_NEAR(graphics[2]["values"]["radius"].get<double>(), 100, 1e-9);
    EXPECT_EQ(graphics[3]["points"].dump(), "[10,21,22]");
    EXPECT_EQ(graphics[4]["shape"], "SPDP");
    EXPECT_EQ(graphics[4]["i"], 30);
    EXPECT_EQ(graphics[4]["values"].dump(), R"({"coils":7.0,"da":4.0})");
    EXPECT_NEAR(graphics[5]["values"]["angle"].get<double>(), SimTK_PI / 2, 1e-12);
}

// What the page makes of a node - pose, point and modes times amplitudes - is where a marker on that node was.
TEST(Report, FlexibleBodiesDeformAsTheyDid) {
    constexpr int Elements = 4, End = Elements + 1;
    UniformBeam beam = testing::makeSteelBeam(Elements);
    beam.youngsModulus /= 200;
    beam.shearModulus /= 200;
    const std::string file = ::testing::TempDir() + "jprim_report_beam.modes";
    saveModalBasis(reduceToModes(makeFiniteElementModel(beam), {{{1}, 0, {}}, {{End}, 0, {}}}, 2), file);
    const Reported r(
        "beam\nUNITS/FORCE=NEWTON,MASS=TONNE,LENGTH=MILLIMETER,TIME=SECOND\nACCGRAV/KGRAV=-500\n"
        "PART/1,GROUND\nMARKER/10,QP=300,200,100\nFLEX_BODY/1,MODES_FILE='" +
            file +
            "',QG=300,200,100,REULER=30D,0,0\nMARKER/20,NODE_ID=1\nMARKER/21,NODE_ID=5,QP=2000,0,0\n"
            "JOINT/1,FIXED,I=20,J=10\nREQUEST/1,DISPLACEMENT,I=21\n",
        {}, 2, 10);
    REQUIRE_PAGE(r);
    const auto& flexible = r.report->json["flexible"].at(0);
    const std::vector<double> points = r.report->read(flexible["points"]),
                              modes = r.report->read(flexible["modes"]),
                              amplitudes = r.report->read(flexible["amplitudes"]),
                              poses = r.report->read(r.report->json["frames"]["poses"]);
    const size_t nodes = points.size() / 3, m = modes.size() / points.size(), parts = 2, end = End - 1;
    ASSERT_EQ(amplitudes.size(), 11 * m);
    double largest = 0;
    for (size_t frame = 0; frame < 11; ++frame) {
        SimTK::Vec3 p(points[3 * end], points[3 * end + 1], points[3 * end + 2]);
        for (size_t mode = 0; mode < m; ++mode)
            for (int k = 0; k < 3; ++k)
                p[k] += amplitudes[frame * m + mode] * modes[(mode * nodes + end) * 3 + size_t(k)];
        largest = std::max(largest, std::abs(p[2]));
        const double* const e = poses.data() + (frame * parts + 1) * 7;
        const SimTK::Rotation R(SimTK::Quaternion(SimTK::Vec4(e[3], e[4], e[5], e[6])));
        const SimTK::Vec3 drawn = SimTK::Vec3(e[0], e[1], e[2]) + R * p;
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(drawn[k], r.results.requests.getColumn(std::string("R1.") + "XYZ"[k])[frame], 2e-3)
                << frame;
    }
    EXPECT_GT(largest, 1);  // it bends by millimetres
}

TEST(Report, TextsCannotEndTheirElement) {
    const std::string hostile =
        "</script><script>window.hostile = 1</script> \"quotes\" 'ä' \\ <!-- é & 日本";
    std::string text = Pendulum;
    text.replace(0, text.find('\n'), hostile);
    ReportNotes notes;
    notes.datasetText = text + "! </SCRIPT >\xff\n";
    notes.file = "</script>.adm";
    notes.summary = {"<!--<script>"};
    notes.warnings = {{"a</script>", {Severity::Warning, {3, 4}, "</script>"}}};
    const Reported r(text, notes);
    REQUIRE_PAGE(r);
    const auto& json = r.report->json;
    EXPECT_EQ(json["title"], hostile);
    EXPECT_EQ(json["text"]["file"], "</script>.adm");
    EXPECT_EQ(json["text"]["dataset"], text + "! </SCRIPT >\xEF\xBF\xBD\n");
    EXPECT_EQ(json["text"]["warnings"][0]["where"], "a</script>:3:4");
    EXPECT_EQ(json["text"]["warnings"][0]["severity"], "warning");
    EXPECT_EQ(json["text"]["summary"][0], "<!--<script>");
}

TEST(Report, ResultsOfAnotherModelAreRefused) {
    const Reported r(Pendulum);
    REQUIRE_PAGE(r);
    Results other = r.results;
    other.parts.columns[1] = "PART/9.X";
    EXPECT_EQ(testing::catchError([&] { writeReport(r.dataset, r.mechanism, other, "none.html"); }),
              "PART/2.X: is not a column of the results; they are not of this model");
    other = r.results;
    other.requests.columns.pop_back();
    EXPECT_EQ(testing::catchError([&] { writeReport(r.dataset, r.mechanism, other, "none.html"); }),
              "results: have other columns than the model; they are not of this model");
    EXPECT_EQ(
        testing::catchError([&] { writeReport(r.dataset, r.mechanism, r.results, "no/such/folder.html"); }),
        "no/such/folder.html: cannot be written");
}

TEST(Report, WhatMattersLeastIsLeftOutFirst) {
    const Reported r(Pendulum, {}, 1, 300);
    REQUIRE_PAGE(r);
    const auto describe = [&](size_t bytes) {
        ReportData data;
        std::vector<std::string> omitted;
        const Json tables = describeTables(r.dataset, r.mechanism, r.results, bytes, data, omitted);
        std::string kept;
        for (const Json& table : tables)
            kept += table["name"].get<std::string>() + " " + std::to_string(table["columns"].size()) + " " +
                    table["data"]["type"].get<std::string>() + " " + table["data"]["shape"].dump() + "; ";
        return kept + std::to_string(omitted.size());
    };
    const size_t rows = 301;
    const std::string first = "requests 7 f64 [7,301]; energy 5 f64 [5,301]; ";
    EXPECT_EQ(describe(1000000), first + "reactions 24 f64 [24,301]; parts 26 f64 [26,301]; 0");
    EXPECT_EQ(describe(rows * 8 * (12 + 24)), first + "reactions 24 f64 [24,301]; 1");
    EXPECT_EQ(describe(rows * 8 * (12 + 12)), first + "reactions 12 f64 [12,301]; 2");
    EXPECT_EQ(describe(rows * 8 * (12 + 6)), first + "reactions 12 f32 [12,301]; 3");
    EXPECT_EQ(describe(rows * 8 * (12 + 3)), first + "reactions 12 f32 [12,151]; 4");
    EXPECT_EQ(describe(0), "requests 7 f32 [7,101]; energy 5 f64 [5,301]; reactions 12 f32 [12,101]; 6");
}

}  // namespace
}  // namespace jprim
