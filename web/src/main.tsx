import { render } from "preact";

import { App } from "./app/app";
import { Permission, token } from "./app/permission";
import { Events } from "./model/events";
import { Units } from "./model/units";
import { LiveSource } from "./source/live_source";
import { RecordedSource } from "./source/recorded_source";
import { wordsOf } from "./source/refusal";
import { embeddedSession } from "./source/session";
import type { Source } from "./source/source";
import "uplot/dist/uPlot.min.css";
import "./style/base.css";
import "./style/overview.css";
import "./style/fleet.css";
import "./style/states.css";
import "./style/hands.css";
import "./style/parameters.css";
import "./style/process_data.css";
import "./style/scope.css";

function sourceOf(): Source {
  const session = embeddedSession(document);
  return session === null ? new LiveSource("", () => token.value) : new RecordedSource(session);
}

function start(root: HTMLElement): void {
  try {
    const source = sourceOf();
    const page = { source, units: new Units(source), events: new Events(source), permission: new Permission(source) };
    page.units.start();
    page.events.start();
    void page.permission.ask();
    render(<App page={page} />, root);
  } catch (error) {
    root.textContent = wordsOf(error);
  }
}

const root = document.getElementById("page");
if (root !== null) start(root);
