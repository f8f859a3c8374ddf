#include "ui/look/appearance.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QFileInfo>
#include <QStyleFactory>

namespace cullscope::ui {

namespace {

constexpr const char* kPortal = "org.freedesktop.portal.Desktop";
constexpr const char* kPortalPath = "/org/freedesktop/portal/desktop";
constexpr const char* kSettings = "org.freedesktop.portal.Settings";
constexpr const char* kGroup = "org.freedesktop.appearance";
constexpr const char* kKey = "color-scheme";
constexpr uint kPrefersDark = 1;

/// Whether a session bus runs. Tested first, because a D-Bus call without a running bus would start one.
bool sessionBusRuns() {
    return !qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") ||
           QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR", QStringLiteral("/nonexistent")) + QStringLiteral("/bus"));
}

/// The portal wraps its answer in one or two variants, depending on its version.
uint unwrapped(QVariant value) {
    while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
    return value.toUInt();
}

void setAllGroups(QPalette& palette, QPalette::ColorRole role, const QColor& colour, const QColor& disabled) {
    palette.setColor(role, colour);
    palette.setColor(QPalette::Disabled, role, disabled);
}

}  // namespace

Appearance::Appearance(QObject* parent) : QObject(parent) {
    m_systemDark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    apply();
    if (sessionBusRuns()) askSystem();
}

void Appearance::askSystem() {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) return;
    bus.connect(QString::fromLatin1(kPortal), QString::fromLatin1(kPortalPath), QString::fromLatin1(kSettings),
                QStringLiteral("SettingChanged"), this, SLOT(systemSettingChanged(QString, QString, QDBusVariant)));
    QDBusMessage question = QDBusMessage::createMethodCall(QString::fromLatin1(kPortal), QString::fromLatin1(kPortalPath),
                                                           QString::fromLatin1(kSettings), QStringLiteral("Read"));
    question << QString::fromLatin1(kGroup) << QString::fromLatin1(kKey);
    auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this](QDBusPendingCallWatcher* watcher) {
        const QDBusPendingReply<QDBusVariant> reply = *watcher;
        if (reply.isValid()) takeSystemScheme(unwrapped(QVariant::fromValue(reply.value())));
        watcher->deleteLater();
    });
}

void Appearance::systemSettingChanged(const QString& group, const QString& key, const QDBusVariant& value) {
    if (group == QLatin1String(kGroup) && key == QLatin1String(kKey)) takeSystemScheme(unwrapped(QVariant::fromValue(value)));
}

void Appearance::takeSystemScheme(uint scheme) {
    m_systemDark = scheme == kPrefersDark;
    apply();
}

void Appearance::setMode(Mode mode) {
    m_mode = mode;
    apply();
}

bool Appearance::dark() const { return m_mode == Mode::Dark || (m_mode == Mode::System && m_systemDark); }

void Appearance::apply() { QApplication::setPalette(palette(dark())); }

QPalette Appearance::palette(bool dark) {
    const QColor window = dark ? QColor(0x1F2329) : QColor(0xF3F4F5);
    const QColor base = dark ? QColor(0x14171C) : QColor(0xFFFFFF);
    const QColor text = dark ? QColor(0xE8EAED) : QColor(0x1A1C1F);
    const QColor disabled = dark ? QColor(0x9AA1AB) : QColor(0x62676E);
    const QColor button = dark ? QColor(0x2B3038) : QColor(0xE6E8EA);
    QPalette palette(button, window);
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, dark ? QColor(0x1B1F25) : QColor(0xF3F4F5));
    palette.setColor(QPalette::Button, button);
    palette.setColor(QPalette::Mid, dark ? QColor(0x0C0E11) : QColor(0xB4B8BD));
    palette.setColor(QPalette::ToolTipBase, dark ? QColor(0x2A3A4A) : QColor(0xE4F0FA));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        setAllGroups(palette, role, text, disabled);
    palette.setColor(QPalette::PlaceholderText, disabled);
    palette.setColor(QPalette::BrightText, Qt::white);
    setAllGroups(palette, QPalette::Highlight, dark ? QColor(0x2F7FD1) : QColor(0x1F66B5), disabled);
    setAllGroups(palette, QPalette::HighlightedText, Qt::white, Qt::white);
    palette.setColor(QPalette::Link, dark ? QColor(0x7CB8F5) : QColor(0x1F66B5));
    return palette;
}

QString Appearance::id(Mode mode) {
    switch (mode) {
        case Mode::System:
            return QStringLiteral("system");
        case Mode::Light:
            return QStringLiteral("light");
        case Mode::Dark:
            return QStringLiteral("dark");
    }
    return {};
}

Appearance::Mode Appearance::fromId(const QString& id) {
    if (id == QStringLiteral("light")) return Mode::Light;
    if (id == QStringLiteral("dark")) return Mode::Dark;
    return Mode::System;
}

}  // namespace cullscope::ui
