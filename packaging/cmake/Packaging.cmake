# The files that `cmake --install` installs besides the programs (app/), and the Debian package that `cpack` makes of all of them.
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/packaging/LICENSES.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
# In the folders that README's links name, so that its links and pictures also work when installed.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/help DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources)
if(CULLSCOPE_DESKTOP)
  install(FILES ${CMAKE_SOURCE_DIR}/packaging/cullscope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${CMAKE_SOURCE_DIR}/packaging/cullscope.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/cullscope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cullscope)
set(CPACK_PACKAGE_VENDOR "Cullscope contributors")
set(CPACK_PACKAGE_CONTACT "Cullscope contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Measures what visibility culling gains and loses")
set(CPACK_PACKAGE_DESCRIPTION "Draws a mesh or a scene by any of several culling strategies, and measures each one's speed against what it loses of the truly visible picture.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# dpkg-shlibdeps finds the linked libraries; those opened at run time are named here.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "glmark2-data, libgl1-mesa-dri, qt6-translations-l10n, fonts-noto-cjk, qt6-wayland")
include(CPack)
