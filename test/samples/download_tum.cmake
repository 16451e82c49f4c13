# The download script on a mirror in a folder: it fetches, resumes, checks sizes, and fails clearly.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

find_program(curl curl)
if(NOT curl)
  message("skipped: no curl")
  return()
endif()
set(name rgbd_dataset_freiburg1_xyz)
set(mirror ${WORK_DIR}/mirror)
set(url --url=file://${mirror})
file(WRITE ${mirror}/${name}/groundtruth.txt "0 0 0 0 0 0 0 1\n")
file(MAKE_DIRECTORY ${mirror}/freiburg1)
execute_process(COMMAND tar -czf ${mirror}/freiburg1/${name}.tgz ${name} WORKING_DIRECTORY ${mirror})

expect(0 "Usage" bash ${PROGRAM} --help)
expect(2 "Usage" bash ${PROGRAM})
expect(2 "unknown option --mirror" bash ${PROGRAM} --mirror=x ${WORK_DIR}/tum)
expect(2 "no sequence 'kitchen' in freiburg1: 360 desk" bash ${PROGRAM} ${WORK_DIR}/tum xyz kitchen)
expect(1 "rgbd_dataset_freiburg1_desk.tgz: cannot be reached" bash ${PROGRAM} ${url} ${WORK_DIR}/tum desk)
expect(1 "cannot be made" bash ${PROGRAM} ${url} ${mirror}/${name}/groundtruth.txt xyz)

expect(0 "${name}: ready" bash ${PROGRAM} ${url} ${WORK_DIR}/tum xyz)
expect(0 "${name}: there already" bash ${PROGRAM} ${url} ${WORK_DIR}/tum xyz)
if(NOT EXISTS ${WORK_DIR}/tum/${name}/groundtruth.txt OR EXISTS ${WORK_DIR}/tum/${name}.tgz)
  message(FATAL_ERROR "the sequence is not as it should be")
endif()

# Half of it from before: the rest is appended, and the archive is whole.
file(REMOVE_RECURSE ${WORK_DIR}/tum/${name})
execute_process(COMMAND head -c 60 ${mirror}/freiburg1/${name}.tgz OUTPUT_FILE ${WORK_DIR}/tum/${name}.tgz)
expect(0 "${name}: ready" bash ${PROGRAM} ${url} ${WORK_DIR}/tum xyz)

# Not what the server has: larger, or no archive at all.
file(REMOVE_RECURSE ${WORK_DIR}/tum/${name})
string(REPEAT "x" 100000 text)
file(WRITE ${WORK_DIR}/tum/${name}.tgz "${text}")
expect(1 "larger than the server's [0-9]+ bytes; remove it" bash ${PROGRAM} ${url} ${WORK_DIR}/tum xyz)
file(REMOVE ${WORK_DIR}/tum/${name}.tgz)
file(WRITE ${mirror}/freiburg1/${name}.tgz "${text}")
expect(1 "cannot be unpacked; remove it" bash ${PROGRAM} ${url} ${WORK_DIR}/tum xyz)
