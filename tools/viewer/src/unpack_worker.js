// What the page's worker runs.
import { serveUnpacking } from "./file/unpacker.js";

const unpack = serveUnpacking((message, parts) => postMessage(message, parts));
onmessage = ({ data }) => unpack(data);
