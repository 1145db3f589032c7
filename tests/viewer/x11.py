"""Screen capture, clipboard and file drops, which xdotool lacks. Calls libX11 directly."""
import ctypes
import time

LONG = ctypes.c_long
CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
REPLACE, CURRENT_TIME, ANY_TYPE = 0, 0, 0
SUBSTRUCTURE_NOTIFY = 1 << 19


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int), ("data", LONG * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("owner", ctypes.c_ulong), ("requestor", ctypes.c_ulong),
                ("selection", ctypes.c_ulong), ("target", ctypes.c_ulong), ("property", ctypes.c_ulong),
                ("time", ctypes.c_ulong)]


class Selection(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("requestor", ctypes.c_ulong), ("selection", ctypes.c_ulong),
                ("target", ctypes.c_ulong), ("property", ctypes.c_ulong), ("time", ctypes.c_ulong)]


class Image(ctypes.Structure):
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.c_void_p), ("byte_order", ctypes.c_int), ("bitmap_unit", ctypes.c_int),
                ("bitmap_bit_order", ctypes.c_int), ("bitmap_pad", ctypes.c_int), ("depth", ctypes.c_int),
                ("bytes_per_line", ctypes.c_int), ("bits_per_pixel", ctypes.c_int)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("client", ClientMessage), ("request", SelectionRequest),
                ("selection", Selection), ("pad", LONG * 24)]


@ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)
def ignore_error(_display, _error):
    """Errors about closed windows are ignored, since the process is checked anyway; by default libX11 would exit."""
    return 0


class Client:
    """A client of the display with an unmapped window of one pixel."""

    def __init__(self):
        self.x = ctypes.CDLL("libX11.so.6")
        self.x.XSetErrorHandler(ignore_error)
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XDefaultRootWindow.restype = self.x.XCreateSimpleWindow.restype = ctypes.c_ulong
        self.x.XInternAtom.restype = ctypes.c_ulong
        self.x.XGetImage.restype = ctypes.POINTER(Image)
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))
        self.pings = 0
        self.size = self.x.XDisplayWidth(self.display, 0), self.x.XDisplayHeight(self.display, 0)
        self.window = ctypes.c_ulong(self.x.XCreateSimpleWindow(self.display, self.root, 0, 0, 1, 1, 0, 0, 0))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.x.XCloseDisplay(self.display)

    def capture(self):
        """The screen as a PPM with 8 bits per channel; its pixels must have 32 bits."""
        width, height = self.size
        image = self.x.XGetImage(self.display, self.root, 0, 0, width, height, ctypes.c_ulong(0xffffff), 2)
        raw = ctypes.string_at(image.contents.data, 4 * width * height)
        self.x.XDestroyImage(image)
        rgb = bytearray(3 * width * height)
        rgb[0::3], rgb[1::3], rgb[2::3] = raw[2::4], raw[1::4], raw[0::4]
        return b"P6 %d %d 255\n" % (width, height) + bytes(rgb)

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), 0)

    def next_event(self, timeout):
        """The next event, or None if none arrives within the timeout in seconds."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            if self.x.XPending(self.display):
                event = Event()
                self.x.XNextEvent(self.display, ctypes.byref(event))
                return event
            time.sleep(0.002)
        return None

    def send(self, window, message, *data):
        event = Event()
        event.client.type, event.client.window, event.client.format = CLIENT_MESSAGE, window, 32
        event.client.message_type = self.atom(message)
        event.client.data = (LONG * 5)(*data)
        self.x.XSendEvent(self.display, ctypes.c_ulong(window), 0, 0, ctypes.byref(event))
        self.x.XFlush(self.display)

    def ping(self, window, timeout):
        """Waits until the window has handled all earlier events. Returns whether it did in time."""
        self.pings += 1
        self.x.XSelectInput(self.display, self.root, LONG(SUBSTRUCTURE_NOTIFY))
        self.send(window, "WM_PROTOCOLS", self.atom("_NET_WM_PING"), self.pings, window, 0, 0)
        end = time.monotonic() + timeout
        while (event := self.next_event(end - time.monotonic())) is not None:
            if event.type == CLIENT_MESSAGE and event.client.data[1] == self.pings:
                return True
        return False

    def read_property(self, name):
        kind, form, count, rest = ctypes.c_ulong(), ctypes.c_int(), ctypes.c_ulong(), ctypes.c_ulong()
        data = ctypes.c_void_p()
        self.x.XGetWindowProperty(self.display, self.window, ctypes.c_ulong(name), LONG(0), LONG(1 << 20), 1,
                                  ctypes.c_ulong(ANY_TYPE), ctypes.byref(kind), ctypes.byref(form),
                                  ctypes.byref(count), ctypes.byref(rest), ctypes.byref(data))
        return ctypes.string_at(data, count.value).decode() if data.value else ""

    def answer(self, request, content):
        """Sends `content` to the requestor of the selection."""
        self.x.XChangeProperty(self.display, ctypes.c_ulong(request.requestor), ctypes.c_ulong(request.property),
                               ctypes.c_ulong(request.target), 8, REPLACE, content, len(content))
        event = Event()
        event.selection.type, event.selection.requestor = SELECTION_NOTIFY, request.requestor
        event.selection.selection, event.selection.target = request.selection, request.target
        event.selection.property, event.selection.time = request.property, request.time
        self.x.XSendEvent(self.display, ctypes.c_ulong(request.requestor), 0, 0, ctypes.byref(event))
        self.x.XFlush(self.display)


def clipboard_text(timeout=20.0):
    """The text in the clipboard."""
    with Client() as client:
        place = client.atom("RAYSCOPE_TEST")
        client.x.XConvertSelection(client.display, ctypes.c_ulong(client.atom("CLIPBOARD")),
                                   ctypes.c_ulong(client.atom("UTF8_STRING")), ctypes.c_ulong(place), client.window,
                                   ctypes.c_ulong(CURRENT_TIME))
        client.x.XFlush(client.display)
        while (event := client.next_event(timeout)) is not None:
            if event.type == SELECTION_NOTIFY:
                return client.read_property(place) if event.selection.property else ""
        return ""


def drop_file(window, path, timeout=20.0):
    """Drops a file onto a window by the protocol XDND, version 5. Returns whether it was accepted."""
    with Client() as client:
        uris = client.atom("text/uri-list")
        selection, copy = client.atom("XdndSelection"), client.atom("XdndActionCopy")
        client.x.XSetSelectionOwner(client.display, ctypes.c_ulong(selection), client.window,
                                    ctypes.c_ulong(CURRENT_TIME))
        own = client.window.value
        client.send(window, "XdndEnter", own, 5 << 24, uris, 0, 0)
        client.send(window, "XdndPosition", own, 0, 200 << 16 | 200, CURRENT_TIME, copy)
        while (event := client.next_event(timeout)) is not None:
            if event.type == SELECTION_REQUEST:
                client.answer(event.request, f"file://{path}\r\n".encode())
            elif event.type == CLIENT_MESSAGE and event.client.message_type == client.atom("XdndStatus"):
                client.send(window, "XdndDrop", own, 0, CURRENT_TIME, 0, 0)
            elif event.type == CLIENT_MESSAGE and event.client.message_type == client.atom("XdndFinished"):
                return bool(event.client.data[1] & 1)
        return False
