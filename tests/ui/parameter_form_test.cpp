#include "ui/panels/parameter_form.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>

#include "core/visibility/registry.h"
#include "ui/text/language.h"

namespace cullscope::ui::parameter_form_test {
namespace {

ParameterDeclaration number(std::string key, ParameterType type, ParameterValue value, double from, double to, std::string unit) {
    ParameterDeclaration declaration;
    declaration.key = std::move(key);
    declaration.type = type;
    declaration.defaultValue = std::move(value);
    declaration.minimum = from;
    declaration.maximum = to;
    declaration.unit = std::move(unit);
    declaration.description = "A sentence about " + declaration.key + ".";
    return declaration;
}

ParameterSet everyType() {
    ParameterDeclaration boolean = number("on", ParameterType::Boolean, true, 0, 0, "");
    return ParameterSet(
        {boolean, number("count", ParameterType::Integer, int64_t(7), 1, 64, "cells"),
         number("size", ParameterType::Real, 2.5, 0.0, 10.0, "px"), number("wide", ParameterType::Real, 1.0, 1e-4, 1e4, ""),
         bySize(number("ratio", ParameterType::Real, 0.002, 0.0, 1.0, ""), 1e-4),
         bySize(number("pixels", ParameterType::Integer, int64_t(1), 0, 1000, "px"), 1.0),
         number("many", ParameterType::Integer, int64_t(4096), 1, 1e7, ""),
         choiceParameter("box", "p-vertex", "How.", {{"p-vertex", "by its corner"}, {"length", "by its length"}})});
}

double numberOf(const ParameterValue& value) {
    const auto* whole = std::get_if<int64_t>(&value);
    return whole ? double(*whole) : std::get<double>(value);
}

struct Form : ::testing::Test {
    Form() {
        form.setParameters(everyType());
        QObject::connect(&form, &ParameterForm::edited, [this](const ParameterSet& parameters) {
            ++edits;
            last = parameters;
        });
    }

    template <typename Widget>
    Widget* field(const char* key) {
        return form.findChild<Widget*>(QString::fromLatin1(key));
    }

    QSpinBox* spin(const char* key) { return field<QWidget>(key)->findChild<QSpinBox*>(); }
    QSlider* slider(const char* key) { return field<QWidget>(key)->findChild<QSlider*>(); }
    QDoubleSpinBox* real(const char* key) { return field<QWidget>(key)->findChild<QDoubleSpinBox*>(); }

    ParameterForm form;
    ParameterSet last;
    int edits = 0;
};

TEST_F(Form, fieldsFollowTheDeclaredTypes) {
    ASSERT_TRUE(field<QCheckBox>("on"));
    EXPECT_TRUE(field<QCheckBox>("on")->isChecked());
    ASSERT_TRUE(field<QWidget>("count") && field<QWidget>("count")->findChild<QSlider*>());
    EXPECT_EQ(field<QWidget>("count")->findChild<QSlider*>()->maximum(), 63) << "a position for each whole number";
    QSpinBox* count = spin("count");
    ASSERT_TRUE(count);
    EXPECT_EQ(count->minimum(), 1);
    EXPECT_EQ(count->maximum(), 64);
    EXPECT_EQ(count->value(), 7);
    EXPECT_EQ(count->suffix(), QStringLiteral(" cells"));
    EXPECT_EQ(field<QWidget>("count")->toolTip(), QStringLiteral("A sentence about count."));
    auto* size = field<QWidget>("size");
    ASSERT_TRUE(size && size->findChild<QSlider*>() && size->findChild<QDoubleSpinBox*>());
    EXPECT_DOUBLE_EQ(size->findChild<QDoubleSpinBox*>()->value(), 2.5);
    EXPECT_EQ(size->findChild<QSlider*>()->value(), 250);
    auto* box = field<QComboBox>("box");
    ASSERT_TRUE(box);
    EXPECT_EQ(box->count(), 2);
    EXPECT_EQ(box->currentData().toString(), QStringLiteral("p-vertex"));
}

TEST_F(Form, changesAreToldAtOnce) {
    field<QCheckBox>("on")->click();
    EXPECT_FALSE(last.boolean("on"));
    spin("count")->setValue(9);
    EXPECT_EQ(last.integer("count"), 9);
    field<QComboBox>("box")->setCurrentIndex(1);
    EXPECT_EQ(last.choice("box"), "length");
    field<QWidget>("size")->findChild<QSlider*>()->setValue(500);
    EXPECT_DOUBLE_EQ(last.real("size"), 5.0);
    EXPECT_EQ(edits, 4);
}

TEST_F(Form, wideRangesSlideByTheirLogarithm) {
    auto* wide = field<QWidget>("wide");
    EXPECT_EQ(wide->findChild<QSlider*>()->value(), 500);
    wide->findChild<QSlider*>()->setValue(1000);
    EXPECT_DOUBLE_EQ(last.real("wide"), 1e4);
}

TEST_F(Form, logarithmsMayBeginAboveZero) {
    EXPECT_EQ(real("ratio")->text(), QStringLiteral("0.002"));
    EXPECT_GT(slider("ratio")->value(), slider("ratio")->maximum() / 4) << "not at the very left";
    slider("ratio")->setValue(0);
    EXPECT_EQ(last.real("ratio"), 0.0);
    slider("ratio")->setValue(1);
    EXPECT_DOUBLE_EQ(last.real("ratio"), 1e-4);
    slider("ratio")->setValue(slider("ratio")->maximum());
    EXPECT_DOUBLE_EQ(last.real("ratio"), 1.0);
    real("ratio")->setValue(0.000125);
    EXPECT_DOUBLE_EQ(last.real("ratio"), 0.000125) << "small numbers are not rounded away";
    real("ratio")->stepUp();
    EXPECT_NEAR(last.real("ratio"), 0.000135, 1e-9) << "a step of a tenth of its size";
}

TEST_F(Form, everyPositionOfASliderIsAnotherNumberAndEveryKeyMovesIt) {
    for (const char* key : {"count", "size", "wide", "ratio", "pixels", "many"}) {
        QSlider* moved = slider(key);
        moved->setValue(0);
        double value = numberOf(form.parameters().value(key));
        for (int position = 1; position <= moved->maximum(); ++position) {
            moved->triggerAction(QAbstractSlider::SliderSingleStepAdd);
            ASSERT_EQ(moved->value(), position) << key;
            const double next = numberOf(form.parameters().value(key));
            ASSERT_GT(next, value) << key << " at " << position;
            value = next;
        }
    }
}

TEST_F(Form, aDragKeepsTheSliderUnderThePointer) {
    QSlider* dragged = slider("pixels");
    dragged->setSliderDown(true);
    dragged->setSliderPosition(3);
    EXPECT_EQ(last.integer("pixels"), 3);
    EXPECT_EQ(dragged->value(), 3);
    dragged->setSliderDown(false);
}

TEST_F(Form, sliderAndNumberMoveTogether) {
    auto* size = field<QWidget>("size");
    size->findChild<QDoubleSpinBox*>()->setValue(7.5);
    EXPECT_EQ(size->findChild<QSlider*>()->value(), 750);
    EXPECT_DOUBLE_EQ(last.real("size"), 7.5);
    EXPECT_EQ(edits, 1);
}

TEST_F(Form, showingValuesIsNoEdit) {
    ParameterSet other = everyType();
    other.set("count", int64_t(30));
    form.setParameters(other);
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(edits, 0);
    EXPECT_EQ(spin("count")->value(), 30);
}

TEST_F(Form, anotherLanguageKeepsTheValues) {
    spin("count")->setValue(11);
    QEvent change(QEvent::LanguageChange);
    QApplication::sendEvent(&form, &change);
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(spin("count")->value(), 11);
    EXPECT_EQ(edits, 1);
}

/// The sentences that are shown without their first or last line.
QStringList cutSentences(const QWidget& form) {
    QStringList cut;
    for (const QLabel* label : form.findChildren<QLabel*>())
        if (label->isVisible() && label->wordWrap() && label->height() < label->heightForWidth(label->width()))
            cut << label->text();
    return cut;
}

/// A scroll bar that appears makes the form narrower, and its page asks once how high it becomes.
TEST(ParameterForms, heightThatAFormStatesForAnotherWidthHasRoomForEverySentenceInEveryLanguage) {
    Language language;
    for (const char* spoken : {"en", "ko", "zh_CN"}) {
        language.use(QString::fromLatin1(spoken));
        for (const RegisteredStrategy& strategy : strategies()) {
            ParameterForm form;
            form.setParameters(ParameterSet(strategy.info.parameters));
            form.resize(600, 1500);
            form.show();
            for (const int width : {260, 246, 232, 400, 218}) {
                form.resize(width, form.heightForWidth(width));
                const QStringList cut = cutSentences(form);
                EXPECT_TRUE(cut.isEmpty()) << spoken << ", " << strategy.info.id << ", " << width << " pixels wide:\n"
                                           << cut.join(QLatin1Char('\n')).toStdString();
                EXPECT_LE(form.minimumSizeHint().width(), 232) << strategy.info.id << ": wider than its page";
            }
        }
    }
    language.use(QStringLiteral("en"));
}

}  // namespace
}  // namespace cullscope::ui::parameter_form_test
