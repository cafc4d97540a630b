// SPDX-License-Identifier: Apache-2.0
// What the columns of requests are called.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/run_dataset.h"

namespace jprim {
namespace {

SimulationOutcome runWith(const std::string& requests) {
    return testing::run(
        testing::buildOrFail("t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,2,3,VX=3,WZ=0.25\n"
                             "MARKER/20\n" +
                             requests + "\nEND\n"),
        1, 1, 1e-8);
}

std::vector<std::string> findColumns(const std::string& requests) {
    return runWith(requests).results.requests.columns;
}

using Names = std::vector<std::string>;

TEST(RequestNames, ComeFromTheDataset) {
    EXPECT_EQ(findColumns("REQUEST/1,CNAMES=\"\",\"swing\",\"rate\",RESULTS_NAME=arm,F2=AZ(20)\\F3=WZ(20)"),
              (Names{"time", "arm.swing", "arm.rate"}));
    EXPECT_EQ(findColumns("REQUEST/1,F1=1\\F2=2\\F5=5\\F8=8"),
              (Names{"time", "R1.F1", "R1.F2", "R1.F5", "R1.F8"}));
    EXPECT_EQ(findColumns("REQUEST/7,CNAMES=a,b,F1=1\\F2=2\\F3=3"), (Names{"time", "R7.a", "R7.b", "R7.F3"}));
    EXPECT_EQ(findColumns("REQUEST/7,RESULTS_NAME=\"my arm\",F4=4"), (Names{"time", "my arm.F4"}));
}

// A displacement has no fifth component.
TEST(RequestNames, BelongToComponents) {
    const std::string names = ",I=20,CNAMES=a,b,c,d,e,f,g,h";
    EXPECT_EQ(findColumns("REQUEST/1,DISPLACEMENT" + names),
              (Names{"time", "R1.a", "R1.b", "R1.c", "R1.d", "R1.f", "R1.g", "R1.h"}));
    EXPECT_EQ(findColumns("REQUEST/1,VELOCITY" + names),
              (Names{"time", "R1.a", "R1.b", "R1.c", "R1.d", "R1.e", "R1.f", "R1.g", "R1.h"}));
    EXPECT_EQ(
        findColumns("REQUEST/1,ACCELERATION,I=20,CNAMES=,x,,,,,,end"),
        (Names{"time", "R1.ACCM", "R1.x", "R1.ACCY", "R1.ACCZ", "R1.WDTM", "R1.WDTX", "R1.WDTY", "R1.end"}));
}

TEST(RequestNames, AreNeverAlike) {
    EXPECT_EQ(
        findColumns("REQUEST/1,RESULTS_NAME=arm,CNAMES=a,a,a,F1=1\\F2=2\\F3=3\n"
                    "REQUEST/2,RESULTS_NAME=arm,CNAMES=a,F1=1\\F2=2\n"
                    "REQUEST/3,RESULTS_NAME=R4,CNAMES=F1,F2,F1=1\\F2=2\n"
                    "REQUEST/4,F1=1\\F2=2"),
        (Names{"time", "arm.a", "R1.F2", "R1.F3", "R2.F1", "arm.F2", "R3.F1", "R3.F2", "R4.F1", "R4.F2"}));
}

// Each component can have its plain name, so this one is never given to another.
TEST(RequestNames, LeaveThePlainNamesOfOthers) {
    EXPECT_EQ(findColumns("REQUEST/1,CNAMES=F2,F1=1\\F2=2\nREQUEST/2,RESULTS_NAME=R1,CNAMES=F1,F1=1"),
              (Names{"time", "R1.F1", "R1.F2", "R2.F1"}));
}

TEST(RequestValues, ThatAreNoNumbersAreToldOnce) {
    const SimulationOutcome outcome =
        runWith("REQUEST/1,F1=SQRT(0.5-TIME)\\F2=TIME\nREQUEST/2,F2=1/(TIME-TIME)\\F3=1/(TIME-TIME)");
    const std::vector<NotFinite>& found = outcome.summary.notFinite;
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].request, "REQUEST/2");
    EXPECT_EQ(found[0].column, "R2.F2");
    EXPECT_EQ(found[0].time, 0);
    EXPECT_EQ(found[1].request, "REQUEST/1");
    EXPECT_EQ(found[1].column, "R1.F1");
    EXPECT_TRUE(std::isnan(found[1].value));
    EXPECT_EQ(found[1].time, 1);
}

TEST(RequestNames, ChangeNoValue) {
    const Table named =
        runWith("REQUEST/1,CUNITS=\"mm\",CNAMES=,go,RESULTS_NAME=x,F1=DM(20)\\F2=2*DX(20)").results.requests;
    const Table plain = runWith("REQUEST/1,F1=DM(20)\\F2=2*DX(20)").results.requests;
    EXPECT_EQ(named.getColumn("x.F1"), plain.getColumn("R1.F1"));
    EXPECT_EQ(named.getColumn("x.go"), plain.getColumn("R1.F2"));
    constexpr double Rounding = 1e-12;
    EXPECT_NEAR(named.getColumn("x.F1").back(), 3, Rounding) << "F1 is the function, not a magnitude of F2";
    EXPECT_NEAR(named.getColumn("x.go").back(), 6, Rounding);
}

TEST(RequestNames, WithMarksAreQuotedInFiles) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "jprim_request_names_test";
    writeResults(runWith("REQUEST/1,CNAMES=\"a, b\",12\",RESULTS_NAME=r,F1=1\\F2=2").results,
                 folder.string());
    std::ifstream file(folder / "requests.csv");
    std::string header;
    std::getline(file, header);
    std::filesystem::remove_all(folder);
    EXPECT_EQ(header, "time,\"r.a, b\",\"r.12\"\"\"");
}

}  // namespace
}  // namespace jprim
