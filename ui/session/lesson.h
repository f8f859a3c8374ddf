#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// The file name extension of lessons without the dot.
inline constexpr const char* kLessonExtension = "lesson";
/// The scene of a lesson that is the program's default one: the bunny where it is installed, else one that needs no file.
inline constexpr const char* kDefaultScene = "default";

/// A sentence by language ("en", "ko", "zh_CN").
using LessonText = std::map<std::string, std::string>;
/// The sentence in a language; in English where that is missing; else in any; empty: there is none.
[[nodiscard]] std::string textIn(const LessonText& text, const std::string& language);

/// Where a camera of a step stands.
struct CameraChoice {
    enum class Kind {
        Usual,  ///< where the program would put it: the scene's first view, or a view from outside
        Given,  ///< as the step's state says
        Pose    ///< a pose of a camera path of the scene
    };
    Kind kind = Kind::Usual;
    std::string path;  ///< Pose: as for cameraPath
    size_t pose = 0;   ///< Pose: from 0

    bool operator==(const CameraChoice&) const = default;
};

/// What the window shows at one step of a lesson, and what is said about it.
struct LessonStep {
    LessonText sentence;
    LessonText notes;    ///< for the presenter alone; may be empty
    SessionState state;  ///< cameras that are not given are those of a new session
    bool defaultScene = false;
    bool saysUp = false;  ///< false: the axis that the scene says, or that is guessed, points up
    CameraChoice camera;  ///< of the linked views
    std::array<CameraChoice, Session::kMostViews> viewing, culling;

    bool operator==(const LessonStep&) const = default;
};

struct Lesson {
    LessonText title;
    std::vector<LessonStep> steps;
};

/// Reads a lesson (docs/files.md, "Lessons"). `file` is where the text was found: error messages name it, and relative names of
/// mesh files begin in its folder. Throws Error(Input) naming file and line.
[[nodiscard]] Lesson lessonFromText(std::string_view text, const std::filesystem::path& file);
/// Reads the title alone, without checking anything else.
[[nodiscard]] LessonText lessonTitle(std::string_view text);

/// Reads a lesson's file. Throws Error(Input) as lessonFromText, and where the file cannot be read.
[[nodiscard]] Lesson loadLesson(const std::filesystem::path& file);

/// The lines of a step that shows `state` after the last step of `before`: the sentence, and what differs. Throws Error(Usage) if
/// no scene is open.
[[nodiscard]] std::string stepText(const Lesson& before, const SessionState& state, const LessonText& sentence,
                                   const std::filesystem::path& file);
/// Appends such a step to a lesson's file, which is made with `title` where there is none yet; written as a whole or not at all.
/// Throws Error(Input) where the file is no lesson, Error(Usage) where it cannot be written.
void appendStep(const std::filesystem::path& file, const LessonText& title, const SessionState& state,
                const LessonText& sentence);

/// The specification of a step's scene.
[[nodiscard]] std::string sceneOf(const LessonStep& step, const SceneSourceOptions& options);
/// Shows a step of which the scene is open. Throws Error(Usage) where a path has no such pose.
void applyStep(Session& session, const LessonStep& step);

}  // namespace cullscope::ui
