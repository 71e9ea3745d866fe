# bin/corpuscle and share/corpuscle. Outside libraries are the system's own and ours are linked in, so no run path is needed.
include(GNUInstallDirs)
if(TARGET corpuscle)
  install(TARGETS corpuscle RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/share/ DESTINATION ${CMAKE_INSTALL_DATADIR}/corpuscle)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
