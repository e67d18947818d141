"""Chapter 15: the machines of a file, a recording or a stream."""
from .recordings import Reader, Values, generated


def root_of(data, path):
    table = generated("Recording").GetRootAs(data, 0)
    if table.Version() not in (1, 2):
        raise ValueError(f"{path}: version {table.Version()}; expected 1 or 2")
    return table


def parts_of(data):
    """The parts of a stream: after 8 bytes each with size and digest, at the end a size of 0."""
    place = 8
    while size := int.from_bytes(data[place:place + 8], "little"):
        yield data[place + 24:place + 24 + size]
        place += 24 + size


def readers(path):
    """The machine of a recording, or those of a stream's windows."""
    with open(path, "rb") as file:
        data = file.read()
    values, machines, opened = Values(), [], {}
    is_stream = data[4:8] == b"GWTS"
    for part in parts_of(data) if is_stream else [data]:
        table = root_of(part, path)
        values.add(table)
        window = (table.Window() or b"").decode()
        if table.Event() == generated("WindowEvent").Open or not is_stream:
            opened[window] = Reader(window, table, values)
            machines.append(opened[window])
        opened[window].parts.append(table)
    return machines
