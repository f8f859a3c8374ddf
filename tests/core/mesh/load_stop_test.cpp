// The interval between checks for a stop request is counted in bytes, not timed, so that the result is the same on any machine.
#include "core/base/error.h"
#include "tests/support/mesh_files.h"

namespace cullscope::test::load_stop_test {
namespace {

constexpr size_t kMostBytesBetweenQuestions = size_t{512} << 10;

class Stopping : public MeshFiles {
protected:
    static std::string largeFile(const std::string& format) {
        std::string text;
        constexpr int kRows = 60'000;
        const auto point = [](int i) {
            return std::to_string(i) + " " + std::to_string(i % 7) + " " + std::to_string(i % 11) + "\n";
        };
        if (format == "obj")
            for (int i = 0; i < kRows; ++i) text += "v " + point(i) + (i > 2 ? "f -1 -2 -3\n" : "");
        if (format == "stl") {
            text = "solid a\n";
            for (int i = 0; i < kRows; ++i)
                text += "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex " + point(i) + "endloop\nendfacet\n";
        }
        if (format == "off") {
            text = "OFF\n" + std::to_string(kRows) + " " + std::to_string(kRows) + " 0\n";
            for (int i = 0; i < kRows; ++i) text += point(i);
            for (int i = 0; i < kRows; ++i) text += "3 0 1 " + std::to_string(i) + "\n";
        }
        if (format == "ply") {
            text =
                "ply\nformat binary_little_endian 1.0\nelement vertex 60000\nproperty float x\nproperty float y\nproperty float "
                "z\n"
                "element face 60000\nproperty list uchar int vertex_indices\nend_header\n";
            for (int i = 0; i < kRows; ++i)
                append(text, static_cast<float>(i), static_cast<float>(i % 7), static_cast<float>(i % 11));
            for (int i = 0; i < kRows; ++i) append(text, uint8_t{3}, i, (i + 1) % kRows, (i + 2) % kRows);
        }
        return text;
    }
};

TEST_F(Stopping, progressIsToldAtLeastEveryHalfMegabyteAndNeverRunsBackwards) {
    for (const std::string format : {"obj", "ply", "stl", "off"}) {
        const std::filesystem::path path = write("large." + format, largeFile(format));
        size_t told = 0;
        double last = 0.0;
        Progress progress;
        progress.report = [&](double share, std::string_view) {
            EXPECT_GE(share, last - 1e-12) << format;
            EXPECT_LE(share, 1.0);
            last = share;
            ++told;
        };
        (void)loadMeshFile(path, {}, progress);
        EXPECT_GE(told, std::filesystem::file_size(path) / kMostBytesBetweenQuestions) << format;
        EXPECT_EQ(last, 1.0);
    }
}

TEST_F(Stopping, aStopAtAnyReportEndsTheLoadBeforeTheNextOne) {
    for (const std::string format : {"obj", "ply", "stl", "off"}) {
        const std::filesystem::path path = write("large." + format, largeFile(format));
        for (size_t stopAt = 1;; ++stopAt) {
            std::stop_source source;
            size_t told = 0;
            double last = 0.0;
            Progress progress;
            progress.stop = source.get_token();
            progress.report = [&](double share, std::string_view) {
                last = share;
                if (++told == stopAt) source.request_stop();
            };
            try {
                (void)loadMeshFile(path, {}, progress);
                EXPECT_EQ(last, 1.0) << "only the last report may come too late";
                break;
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
                EXPECT_EQ(told, stopAt) << format;
            }
        }
    }
}

}  // namespace
}  // namespace cullscope::test::load_stop_test
