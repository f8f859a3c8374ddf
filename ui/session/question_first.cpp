#include "ui/session/question_first.h"

#include <QCoreApplication>
#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/scene/eye_triangle.h"

namespace cullscope::ui {

namespace {

std::string nameOf(const SnapshotNode& row) { return row.name.empty() ? std::to_string(row.number) : row.name; }

/// The place that a group of the tree stands for: its own, or that of the leaf in which it lies.
std::optional<size_t> placeOf(const NamedParts& parts, const StructureSnapshot& snapshot, size_t node) {
    for (auto row = int32_t(node); row >= 0; row = snapshot.nodes[size_t(row)].parent) {
        const auto found = std::ranges::find(parts.places, nameOf(snapshot.nodes[size_t(row)]));
        const auto place = size_t(found - parts.places.begin());
        if (found != parts.places.end() && (row == int32_t(node) || place < parts.leaves)) return place;
    }
    return std::nullopt;
}

}  // namespace

QuestionFirst::QuestionFirst(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    // Other objects have other numbers.
    connect(&session, &Session::sceneChanged, this, &QuestionFirst::withdraw);
    connect(&session, &Session::hiddenChanged, this, &QuestionFirst::withdraw);
    // Another frame may have other parts.
    for (const auto signal : {&Session::cameraChanged, &Session::activeViewChanged})
        connect(&session, signal, this, &QuestionFirst::readParts);
    for (const auto signal : {&Session::strategyBuilt, &Session::setupChanged})
        connect(&session, signal, this, &QuestionFirst::readParts);
}

void QuestionFirst::ask(Prediction::Question question, const std::optional<Prediction::Items>& of) {
    if (!m_session.scene() || !m_session.gpu()) return;
    const bool vanish = question == Prediction::Question::Vanish;
    m_session.setQuestion(Prediction{question, vanish ? of.value_or(usualItems()) : usualItems()});
    readParts();
}

Prediction::Question QuestionFirst::usualQuestion() const {
    const bool divided = m_session.scene() && !m_session.scene()->planes().empty();
    return divided ? Prediction::Question::Order : Prediction::Question::Vanish;
}

Prediction::Items QuestionFirst::usualItems() const {
    return m_session.scene()->instances().size() == 1 ? Prediction::Items::Triangles : Prediction::Items::Objects;
}

void QuestionFirst::answerBy(const BuiltStrategy& strategy, const StructureSnapshot& snapshot, size_t node) {
    if (!m_session.question()) return;
    if (m_session.question()->question == Prediction::Question::Place) {
        if (m_session.questionParts()) answerPlaceBy(snapshot, node);
        return;
    }
    const std::vector<uint64_t> items = itemsBelow(strategy, snapshot, node);
    Prediction named = *m_session.question();
    if (!items.empty()) named.toggle(items);
    m_session.setQuestion(named);
}

void QuestionFirst::answerPlaceBy(const StructureSnapshot& snapshot, size_t node) {
    const NamedParts& parts = *m_session.questionParts();
    if (parts.places.empty()) return;
    const auto say = [this](const char* why, const std::vector<std::string>& arguments = {}) {
        m_session.raise(Severity::Information, {why, arguments});
    };
    Prediction placed = *m_session.question();
    const SnapshotNode& row = snapshot.nodes[node];
    if (row.isGroup()) {
        if (placed.items.empty()) return say(QT_TRANSLATE_NOOP("core", "First click the part, then the leaf in which it lies."));
        if (const std::optional<size_t> found = placeOf(parts, snapshot, node)) return place(*found);
        return say(QT_TRANSLATE_NOOP("core", "%1 is no answer here: the list beside the question has all of them."),
                   {nameOf(row)});
    }
    const std::string& object = m_session.scene()->instances()[row.instance].name;
    switch (std::ranges::count(parts.parts, row.instance, &NamedParts::Part::object)) {
        case 0:
            return say(QT_TRANSLATE_NOOP("core", "Nothing of %1 is drawn: it lies nowhere."), {object});
        case 1:
            break;
        default:
            return say(QT_TRANSLATE_NOOP("core", "%1 has several parts: click one of them in a view."), {object});
    }
    const auto found = std::ranges::find(parts.parts, row.instance, &NamedParts::Part::object);
    placed.toggle(uint64_t(found - parts.parts.begin()));
    m_session.setQuestion(placed);
}

NamedParts QuestionFirst::partsFor(Prediction::Question question, const BuiltStrategy& strategy, const FrameLog& log) {
    return question == Prediction::Question::Place ? strategy.partsByLeaf(log) : strategy.parts(log);
}

std::vector<uint64_t> QuestionFirst::itemsBelow(const BuiltStrategy& strategy, const StructureSnapshot& snapshot,
                                                size_t node) const {
    const Scene& scene = *m_session.scene();
    std::set<uint32_t> objects, groups;
    for (size_t i = 0; i < snapshot.nodes.size(); ++i) {
        size_t above = i;
        while (above != node && snapshot.nodes[above].parent >= 0) above = size_t(snapshot.nodes[above].parent);
        if (above != node) continue;
        const SnapshotNode& below = snapshot.nodes[i];
        (below.isGroup() ? groups : objects).insert(below.isGroup() ? below.number : below.instance);
    }
    // Of a tree that holds triangles or parts of them.
    const auto holds = [&](uint64_t triangle, const std::array<Vec3, 3>& corners) {
        const std::optional<uint32_t> group = strategy.groupAt(triangle, (corners[0] + corners[1] + corners[2]) / 3.0);
        return group && groups.contains(*group);
    };
    std::vector<uint64_t> items;
    switch (m_session.question()->of) {
        case Prediction::Items::Objects:
            items.assign(objects.begin(), objects.end());
            break;
        case Prediction::Items::Triangles:
            for (uint32_t object = 0; object < scene.instances().size(); ++object) {
                const InstanceFromEye corners(scene, object, Vec3(0.0));
                for (uint64_t i = 0; i < scene.meshOf(object).triangleCount() && items.size() < kMostTriangles; ++i) {
                    const uint64_t triangle = scene.firstTriangle(object) + i;
                    const bool searched = objects.empty() && scene.triangleCount() <= kMostSearched;
                    if (objects.contains(object) || (searched && holds(triangle, corners.corners(i)))) items.push_back(triangle);
                }
            }
            break;
        case Prediction::Items::Parts:
            const NamedPartsPointer& parts = m_session.questionParts();
            for (uint64_t i = 0; parts && i < parts->parts.size(); ++i) {
                const NamedParts::Part& part = parts->parts[i];
                const uint32_t first = part.drawn.front().first;
                const bool held = holds(parts->own->triangles[first], worldCorners(*parts->own, first, scene, part.object));
                if (held || objects.contains(part.object)) items.push_back(i);
            }
    }
    return items;
}

void QuestionFirst::place(size_t place) {
    if (!m_session.question()) return;
    Prediction placed = *m_session.question();
    placed.place(place);
    m_session.setQuestion(placed);
}

void QuestionFirst::readParts() {
    const std::optional<ViewRequest> request = m_session.viewRequest(m_session.activeView());
    if (!m_session.question() || m_session.question()->question == Prediction::Question::Vanish || !request) return;
    GpuThread& gpu = *m_session.gpu();
    const auto read = [this, &gpu, request = *request, question = m_session.question()->question,
                       frames = m_session.frames()](GpuJobs::Step& step) {
        if (gpu.lost()) return;
        try {
            const ViewFramePointer frame = frames->of(request.frame(), gpu.renderer());
            const auto parts = std::make_shared<const NamedParts>(partsFor(question, *request.strategy, frame->log));
            step.deliver([this, parts] { take(parts); });
        } catch (const Error&) {
            // The question stays one about objects; the view tells of the failure.
        }
    };
    m_reading.start(gpu, read, {.buffers = {request->buffers}, .urgency = Urgency::Picture});
}

void QuestionFirst::take(const NamedPartsPointer& parts) {
    if (!m_session.question() || m_session.question()->question == Prediction::Question::Vanish) return;
    const bool byPlace = m_session.question()->question == Prediction::Question::Place;
    Prediction question = *m_session.question();
    if (!byPlace && !(parts->divides() && parts->parts.size() <= kMostParts)) {
        // Another strategy had parts before.
        if (question.of == Prediction::Items::Parts) m_session.setQuestion(Prediction{question.question, usualItems()});
        return;
    }
    const NamedPartsPointer& before = m_session.questionParts();
    const bool same = before && before->places == parts->places &&
                      std::ranges::equal(before->parts, parts->parts, {}, &NamedParts::Part::name, &NamedParts::Part::name);
    if (!same) question = Prediction{question.question};
    question.of = Prediction::Items::Parts;
    m_session.setQuestion(question, parts);
}

void QuestionFirst::withdraw() {
    m_jobs.cancel();
    m_reading.cancel();
    m_session.setQuestion(std::nullopt);
}

bool QuestionFirst::isAnswered() const {
    const std::optional<Prediction>& question = m_session.question();
    if (!question || question->items.empty()) return false;
    const auto isSaid = [](const std::optional<size_t>& place) { return place.has_value(); };
    return question->question != Prediction::Question::Place || std::ranges::any_of(question->places, isSaid);
}

void QuestionFirst::reveal() {
    const std::optional<ViewRequest> request = m_session.viewRequest(m_session.activeView());
    if (!isAnswered() || !request) return;
    GpuThread& gpu = *m_session.gpu();
    const auto compare = [this, &gpu, request = *request, prediction = *m_session.question(),
                          frames = m_session.frames()](GpuJobs::Step& step) {
        if (gpu.lost()) return;
        std::vector<PredictionRow> rows;
        NamedPartsPointer parts;
        Message failure;
        try {
            const bool ofParts = prediction.of == Prediction::Items::Parts;
            const ViewFramePointer frame = frames->of(request.frame(), gpu.renderer());
            if (ofParts) parts = std::make_shared<const NamedParts>(partsFor(prediction.question, *request.strategy, frame->log));
            rows = answerTo(prediction, request.buffers->scene(), frame->log, ofParts ? *parts : NamedParts());
        } catch (const Error& error) {
            failure = error.message();
        }
        step.deliver([this, prediction, rows, parts, failure] {
            m_session.setQuestion(std::nullopt);
            if (failure.empty())
                emit answered(prediction, rows, parts);
            else
                m_session.raise(Severity::Error, failure);
        });
    };
    m_jobs.start(gpu, compare, {.buffers = {request->buffers}, .urgency = Urgency::Picture});
}

}  // namespace cullscope::ui
