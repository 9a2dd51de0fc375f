# A row a package.
debian_package(axisd SECTION utils
  DEPENDS passwd
  RECOMMENDS "can-userbus (= ${full_version})" iproute2
  SUGGESTS axisd-doc axisd-fleet axisd-http canopen-tools can-utils
  DESCRIPTION "simulated CANopen drive unit on a CAN bus
A daemon that behaves on CAN as a Siemens SINAMICS S120 drive unit (CU320-2
with CBC10) does: object dictionary, state machine, parameters, faults and
abort codes, with motors that obey physics. CANopen masters can be developed
and tested against it without hardware, on SocketCAN or on a bus in user
space.
.
This package has the daemon, its services for systemd and axisctl, which looks
inside and disturbs it.")

debian_package(libcanopen0 SECTION libs
  DESCRIPTION "CANopen slave library after CiA 301 - shared library
A CANopen slave that makes no operating system calls and allocates nothing
after its construction: object dictionary, SDO, PDO, NMT, SYNC, EMCY, TIME,
heartbeat, guarding and storage.
.
This package has what programs need that use the library.")

debian_package(libcanopen-dev SECTION libdevel
  DEPENDS "libcanopen0 (= ${full_version})" libexpected-dev
  SUGGESTS axisd-doc canopen-tools
  DESCRIPTION "CANopen slave library after CiA 301 - development files
A CANopen slave that makes no operating system calls and allocates nothing
after its construction: object dictionary, SDO, PDO, NMT, SYNC, EMCY, TIME,
heartbeat, guarding and storage.
.
This package has headers (C++20), the archive, and what CMake and pkg-config
look for.")

debian_package(can-userbus SECTION utils
  SUGGESTS can-utils axisd
  DESCRIPTION "CAN bus in user space for unmodified SocketCAN programs
Where the kernel has no CAN, as in containers and on hosted runners, canhub
serves a bus at a Unix socket, and with-can runs programs that were written
for SocketCAN on it, such as can-utils and python-can. No privilege is needed.
A hub bridges to SocketCAN, UDP multicast and socketcand, and joins the hubs of
other hosts over a NATS server. canrec records such a bus, and plays recordings
and logs of candump.")

debian_package(canopen-tools SECTION utils
  SUGGESTS axisd axisd-doc
  DESCRIPTION "tools for CANopen devices and their EDS files
canopen-check tests any CANopen slave against CiA 301 and its EDS, and writes
reports in JSON and JUnit XML. canopen-audit judges CANopen masters by the
frames of a bus or of a log. canopen-zoo is a slave that is wrong in one
thing, for those who test masters and tools. edstool reads, checks, compares
and makes EDS and DCF files (CiA 306).")

debian_package(python3-axisd ALL SECTION python
  DEPENDS "python3 (>= 3.11)" "axisd (>= ${full_version})" "can-userbus (>= ${full_version})"
  RECOMMENDS python3-pytest
  SUGGESTS axisd-doc python3-can python3-pytest-xdist
  DESCRIPTION "simulated CANopen drive units in tests - Python
A test gets a drive unit on a CAN bus of its own, without privileges and in
parallel with others: it injects faults, waits for states, values and frames,
and shows frames and the state of the unit when it fails.
.
This package has the module axisd, fixtures for pytest, and the user-space bus
as an interface of python-can.")

debian_package(axisd-dev ALL SECTION libdevel
  DEPENDS "axisd (>= ${full_version})" "can-userbus (>= ${full_version})" nlohmann-json3-dev
  SUGGESTS axisd-doc libgtest-dev
  DESCRIPTION "simulated CANopen drive units in tests - C++
A test gets a drive unit on a CAN bus of its own, without privileges and in
parallel with others: it injects faults, waits for states, values and frames,
and shows frames and the state of the unit when it fails.
.
This package has the header axisd/testing.hpp, with GoogleTest or without.")

debian_package(node-axisd ALL SECTION javascript
  DEPENDS "nodejs (>= 18)" "axisd (>= ${full_version})" "can-userbus (>= ${full_version})" can-utils
  SUGGESTS axisd-doc
  DESCRIPTION "simulated CANopen drive units in tests - Node.js
A test gets a drive unit on a CAN bus of its own, without privileges and in
parallel with others: it injects faults, waits for states, values and frames,
and shows frames and the state of the unit when it fails.
.
This package has the module axisd of Node.js.")

debian_package(axisd-doc ALL SECTION doc
  SUGGESTS axisd
  DESCRIPTION "documentation of axisd and libcanopen
Pages on the simulated drive unit, its objects, parameters and interfaces, the
bus in user space, the tools, and the library for CANopen slaves; and the
examples: masters, a CANopen slave, recipes for continuous integration.")

debian_package(axisd-fleet SECTION utils
  DEPENDS passwd
  RECOMMENDS "axisd (= ${full_version})" "can-userbus (= ${full_version})"
  SUGGESTS axisd-doc nats-server
  DESCRIPTION "simulated CANopen drive units of many hosts
The units of axisd on a machine as units of a farm: axisctl, the HTTP gateway
and any client of NATS reach them over a NATS server, and are told what they
do.
.
This package has what a host of a farm has for that: axisd-nats, by which its
units are reached, axisd-agent, which starts the units that are wanted, and
their services.")

if(TARGET axisd-http)
  debian_package(axisd-http SECTION utils
    DEPENDS passwd
    RECOMMENDS axisd
    SUGGESTS axisd-doc
    DESCRIPTION "HTTP gateway to simulated CANopen drive units
Serves all units of axisd on a machine over HTTP: REST and streams of events,
described by OpenAPI, and metrics in the text format of Prometheus. It listens
on the loopback addresses unless told otherwise; writing takes a token.")
endif()
