#pragma once

#include <QDBusVariant>
#include <QObject>
#include <QPalette>

namespace cullscope::ui {

/// The light or dark palette: as the system is set (desktop portal, else the system's palette), or as the user chose.
class Appearance : public QObject {
    Q_OBJECT

public:
    enum class Mode { System, Light, Dark };

    explicit Appearance(QObject* parent = nullptr);

    [[nodiscard]] Mode mode() const { return m_mode; }
    void setMode(Mode mode);
    [[nodiscard]] bool dark() const;

    [[nodiscard]] static QPalette palette(bool dark);
    /// The mode's name in the settings: "system", "light" or "dark".
    [[nodiscard]] static QString id(Mode mode);
    [[nodiscard]] static Mode fromId(const QString& id);

private slots:
    void systemSettingChanged(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void askSystem();
    void takeSystemScheme(uint scheme);
    void apply();

    Mode m_mode = Mode::System;
    bool m_systemDark = false;
};

}  // namespace cullscope::ui
