# Files that cannot be used: exit code 1 and a message that names the file and the line.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

set(head "# fx fy cx cy 500 500 320 240\n")
set(row "0.1 0.2 3 300 200\n")

expect(1 "nowhere.txt: cannot be opened" ${PROGRAM} ${WORK_DIR}/nowhere.txt)
expect(1 "${WORK_DIR}: cannot be read" ${PROGRAM} ${WORK_DIR})

function(expect_bad name text message)
  file(WRITE ${WORK_DIR}/${name}.txt "${text}")
  expect(1 "${name}.txt:${message}" ${PROGRAM} ${WORK_DIR}/${name}.txt)
endfunction()

expect_bad(short_row "${head}${row}0.1 0.2 3 300\n" "3: expected 5 numbers, found 4")
expect_bad(words "${head}${row}${row}0.1 0.2 three 300 200\n" "4: 'three' is not a finite number")
expect_bad(nan "${head}0.1 0.2 nan 300 200\n" "2: 'nan' is not a finite number")
expect_bad(too_few "${head}${row}${row}${row}" "4: the file ends after 3 points; at least 4 are needed")
expect_bad(no_camera "${row}${row}${row}${row}" "4: the file ends without a '# fx fy cx cy' line")
expect_bad(empty "" "0: the file ends after 0 points")

# A good file before a bad one does not hide it.
file(GLOB files ${SAMPLES_DATA}/*.txt)
list(GET files 0 good)
expect(1 "short_row.txt:3" ${PROGRAM} --repeat=1 ${good} ${WORK_DIR}/short_row.txt)

# Readable, but no pose: collinear points are reported and fail the run.
set(line "${head}")
foreach(i RANGE 1 8)
  string(APPEND line "${i} ${i} ${i}0 ${i}00 ${i}00\n")
endforeach()
file(WRITE ${WORK_DIR}/collinear.txt "${line}")
expect(1 "collinear.txt: no pose" ${PROGRAM} --repeat=1 --method=GMLPNP_MARGINAL ${WORK_DIR}/collinear.txt)
