// The event queue, valuators, buttons.
#include "irisgl/state/events.h"
#include "irisgl/calls/shared.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include "generated/irisgl/calls.h"

#include <algorithm>
#include <string>

namespace gw::irisgl::calls {

namespace {

Events& events() { return program().events; }

bool is_device(const char* function, unsigned device) {
    if (device >= 1 && device < MAXDEVICE) return true;
    warn(std::string(function) + ": device " + std::to_string(device) +
         " is not known; it is ignored");
    return false;
}

}  // namespace

void qdevice(Device d) {
    if (is_device("qdevice", d)) events().queued.insert(d);
}
void unqdevice(Device d) { events().queued.erase(d); }
Boolean isqueued(Device d) { return events().queued.contains(d) ? 1 : 0; }

long qread(short* value) {
    poll(events().queue.empty());
    if (events().queue.empty()) return 0;
    const Event e = take();
    if (value != nullptr) *value = short(e.value);
    return long(e.device);
}

long qtest() {
    poll(false);
    return events().queue.empty() ? 0 : long(events().queue.front().device);
}

void qenter(short device, short value) { enter(unsigned(device), value); }
void qreset() { events().queue.clear(); }

long blkqread(short* data, short n) {
    poll(events().queue.empty());
    short count = 0;
    while (data != nullptr && count + 1 < n && !events().queue.empty()) {
        const Event e = take();
        data[count++] = short(e.device);
        data[count++] = short(e.value);
    }
    return count;
}

void tie(Device button, Device v1, Device v2) {
    if (button >= 256)
        return warn("tie: device " + std::to_string(button) + " is no button; it is ignored");
    if (v1 == 0 && v2 == 0)
        events().ties.erase(button);
    else
        events().ties[button] = {v1, v2};
}

Boolean getbutton(Device d) {
    poll(false);
    return events().down.contains(d) ? 1 : 0;
}
long getvaluator(Device d) {
    poll(false);
    if (!is_valuator(d)) {
        warn("getvaluator: device " + std::to_string(d) + " is no valuator; it returns -1");
        return -1;
    }
    return events().valuators[d].value;
}
void setvaluator(Device d, short value, short low, short high) {
    if (!is_valuator(d)) return warn("setvaluator: the device is no valuator; it is ignored");
    if (low > high)
        return warn("setvaluator: the least value is above the greatest; it is ignored");
    const long at = std::clamp(value, low, high);
    events().valuators[d] = {.value = at, .low = low, .high = high, .queued = at};
}
void getdev(long n, Device* devices, short* values) {
    if (devices == nullptr || values == nullptr) return;
    for (long i = 0; i < std::min(n, 128L); ++i)  // "up to 128"
        values[i] = short(devices[i] < 256 ? getbutton(devices[i]) : getvaluator(devices[i]));
}
void noise(Device d, short delta) { events().noise[d] = delta; }
void attachcursor(Device, Device) {}
long qgetfd() {
    warn("qgetfd: the queue has no file; it returns -1");
    return -1;
}
void setbell(char) {}
void ringbell() {
    if (program().current != nullptr && current_window().host() != nullptr)
        current_window().host()->ring();
}
void lampon(char) {}
void lampoff(char) {}
void clkon() {}
void clkoff() {}
void setdblights(unsigned long) {}
void dbtext(const std::string&) {}

}  // namespace gw::irisgl::calls
