//! A headless browser and its DevTools, through two named pipes: no socket, no port, no crate.
//!
//! Messages are JSON with a zero byte behind each. Source: the DevTools protocol, `--remote-debugging-pipe`.

use serde_json::{Value, json};
use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

/// The longest wait for an answer; the machine may be busy.
const PATIENCE: Duration = Duration::from_secs(120);

/// The browser's program, if there is one.
pub fn program() -> Option<&'static str> {
    let paths = std::env::var_os("PATH").unwrap_or_default();
    let is_there = |name: &&str| std::env::split_paths(&paths).any(|folder| folder.join(name).is_file());
    let found = ["chromium", "chromium-browser", "google-chrome"].into_iter().find(is_there);
    if found.is_none() {
        println!("notice: no chromium is installed, the report is not opened in one");
    }
    found
}

/// A page in a browser that ends with the test.
pub struct Page {
    browser: Child,
    commands: File,
    answers: Receiver<Value>,
    session: Option<String>,
    number: u64,
    /// What came besides answers.
    pub events: Vec<Value>,
}

impl Drop for Page {
    fn drop(&mut self) {
        let _ = self.browser.kill();
        let _ = self.browser.wait();
    }
}

impl Page {
    /// Starts the browser; its pipes and its profile lie in `folder`.
    pub fn open(program: &str, folder: &Path) -> Page {
        let made = Command::new("mkfifo").args(["commands", "answers"]).current_dir(folder).status();
        assert!(made.is_ok_and(|status| status.success()), "two named pipes");
        let line = format!(
            "exec {program} --headless --no-sandbox --disable-gpu --no-first-run --hide-scrollbars --user-data-dir=profile \
             --remote-debugging-pipe 3<commands 4>answers"
        );
        let mut shell = Command::new("sh");
        shell.args(["-c", &line]).current_dir(folder).env("HOME", folder).stdin(Stdio::null());
        let browser = shell.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("sh starts");
        // The shell opens the first pipe, then the second; each waits for its other end.
        let commands = File::options().write(true).open(folder.join("commands")).expect("the pipe opens");
        let incoming = File::open(folder.join("answers")).expect("the pipe opens");
        let (sender, answers) = channel();
        std::thread::spawn(move || {
            for message in BufReader::new(incoming).split(0).map_while(Result::ok) {
                let Ok(value) = serde_json::from_slice(&message) else { continue };
                if sender.send(value).is_err() {
                    return;
                }
            }
        });
        let mut page = Page { browser, commands, answers, session: None, number: 0, events: Vec::new() };
        let target = page.ask("Target.createTarget", json!({ "url": "about:blank" }));
        let attached = page.ask("Target.attachToTarget", json!({ "targetId": target["targetId"], "flatten": true }));
        page.session = attached["sessionId"].as_str().map(str::to_string);
        for name in ["Page.enable", "Network.enable", "Runtime.enable"] {
            page.ask(name, json!({}));
        }
        page
    }

    /// Sends a command and waits for its answer.
    pub fn ask(&mut self, method: &str, parameters: Value) -> Value {
        self.number += 1;
        let mut message = json!({ "id": self.number, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            message["sessionId"] = session.as_str().into();
        }
        self.commands.write_all(format!("{message}\0").as_bytes()).expect("the browser listens");
        loop {
            let mut value = self.next();
            if value["id"] == self.number {
                assert!(value.get("error").is_none(), "{method}: {value}");
                return value["result"].take();
            }
            self.events.push(value);
        }
    }

    fn next(&mut self) -> Value {
        self.answers.recv_timeout(PATIENCE).expect("the browser answers")
    }

    /// Opens an address and waits until all of it is there.
    pub fn go(&mut self, address: &str) {
        self.events.clear();
        // A page that differs in its fragment alone would not be loaded.
        self.ask("Page.navigate", json!({ "url": "about:blank" }));
        self.wait_for("Page.loadEventFired");
        self.events.clear();
        self.ask("Page.navigate", json!({ "url": address }));
        self.wait_for("Page.loadEventFired");
    }

    fn wait_for(&mut self, method: &str) {
        while !self.events.iter().any(|event| event["method"] == method) {
            let value = self.next();
            self.events.push(value);
        }
    }

    /// The value of an expression in the page.
    pub fn value(&mut self, expression: &str) -> Value {
        let answer = self.ask("Runtime.evaluate", json!({ "expression": expression, "returnByValue": true }));
        assert!(answer.get("exceptionDetails").is_none(), "{expression}: {answer}");
        answer["result"]["value"].clone()
    }

    /// Text of an expression.
    pub fn text(&mut self, expression: &str) -> String {
        self.value(expression).as_str().unwrap_or_default().to_string()
    }

    /// A click of the mouse at a place of the window.
    pub fn click(&mut self, (x, y): (f64, f64)) {
        for kind in ["mousePressed", "mouseReleased"] {
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1 });
            self.ask("Input.dispatchMouseEvent", event);
        }
    }

    /// A key, down and up.
    pub fn press(&mut self, key: &str, code: u32) {
        for kind in ["keyDown", "keyUp"] {
            let event = json!({ "type": kind, "key": key, "code": key, "windowsVirtualKeyCode": code });
            self.ask("Input.dispatchKeyEvent", event);
        }
    }

    /// The window as a PNG.
    pub fn screenshot(&mut self) -> Vec<u8> {
        let answer = self.ask("Page.captureScreenshot", json!({ "format": "png" }));
        super::base64::decoded(answer["data"].as_str().expect("a picture"))
    }
}
