using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using System.Text;
using System.Threading;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples.Terminal;

/// <summary>Shows a scene live until the user leaves it.</summary>
internal sealed class WatchSession
{
    private const double FramesPerSecond = 30.0;
    private const int LeastSpeed = -5;
    private const int GreatestSpeed = 5;

    /// <summary>What the keys do, for the last row and for the help.</summary>
    public const string KeyText =
        "q quit  space pause  n step  + - speed  r restart  c contacts  tab chooses a body, w a s d throw it, the mouse drags it";

    /// <summary>Dots from the mouse at which a body is still grabbed: two characters.</summary>
    private const double Reach = 4.0;

    /// <summary>Of the picture's height, what a key adds to a body's speed, a second.</summary>
    private const float ThrowShare = 0.25f;

    /// <summary>Of a frame, the part that may go into stepping: keys must stay lively when a scene is too big for real time.</summary>
    private const double StepShare = 0.8;
    private readonly Scene _scene;
    private readonly RunOptions _options;
    private readonly BrailleCanvas _canvas = new();
    private readonly ScenePainter _painter;
    private readonly List<string> _rows = [];
    private readonly bool _colored = AnsiConsole.Profile.Capabilities.ColorSystem != ColorSystem.NoColors;
    private SceneRun _run;
    private Hand _hand;
    private IReadOnlyList<SceneOutcome> _outcomes = [];
    private bool _paused;
    private bool _quit;
    private bool _contacts;
    private bool _late;
    private int _speed;
    private double _due;

    public WatchSession(Scene scene, RunOptions options)
    {
        _scene = scene;
        _options = options;
        _painter = new ScenePainter(_canvas);
        _run = new SceneRun(scene, options);
        _hand = new Hand(_run.Simulator);
    }

    public void Run()
    {
        using TerminalScreen screen = new();
        long last = Stopwatch.GetTimestamp();
        while (!_quit)
        {
            while (Console.KeyAvailable)
            {
                HandleNext(Console.ReadKey(intercept: true));
            }

            long now = Stopwatch.GetTimestamp();
            Advance((double)(now - last) / Stopwatch.Frequency);
            last = now;
            Draw(screen);
            double spent = (double)(Stopwatch.GetTimestamp() - now) / Stopwatch.Frequency;
            Thread.Sleep((int)Math.Max(1.0, 1000.0 * ((1.0 / FramesPerSecond) - spent)));
        }
    }

    /// <summary>What has arrived already: a report of the mouse comes in one piece, a key of the user's alone.</summary>
    private static char? NextCharacter() => Console.KeyAvailable ? Console.ReadKey(intercept: true).KeyChar : null;

    private void HandleNext(ConsoleKeyInfo key)
    {
        if (key.Key != ConsoleKey.Escape || !Console.KeyAvailable)
        {
            Handle(key);
        }
        else if (MouseEvent.Read(NextCharacter) is MouseEvent mouse)
        {
            Handle(mouse);
        }
    }

    private void Handle(MouseEvent mouse)
    {
        // The first row is the headline; the middle of a character's dots is meant.
        Vector2 point = _painter.ToWorld((2.0 * mouse.Column) + 0.5, (4.0 * (mouse.Row - 1)) + 1.5);
        switch (mouse.Action)
        {
            case MouseAction.Press:
                _hand.Grab(point, _painter.ToWorld(Reach));
                break;
            case MouseAction.Drag:
                _hand.Lead(point);
                break;
            default:
                _hand.Release();
                break;
        }
    }

    private void Throw(float right, float up) =>
        _hand.Throw(ThrowShare * _painter.ToWorld(_canvas.Height) * ((right * Vector2.UnitX) + (up * _painter.Up)));

    private void Handle(ConsoleKeyInfo key)
    {
        bool leaves = key.Key is ConsoleKey.Q or ConsoleKey.Escape
            || (key.Key == ConsoleKey.C && (key.Modifiers & ConsoleModifiers.Control) != 0);
        if (leaves)
        {
            _quit = true;
        }
        else if (key.Key == ConsoleKey.Spacebar)
        {
            _paused = !_paused;
        }
        else if (key.Key is ConsoleKey.RightArrow or ConsoleKey.N)
        {
            _paused = true;
            Step();
        }
        else if (key.KeyChar is '+' or '=' || key.Key == ConsoleKey.UpArrow)
        {
            _speed = Math.Min(_speed + 1, GreatestSpeed);
        }
        else if (key.KeyChar is '-' or '_' || key.Key == ConsoleKey.DownArrow)
        {
            _speed = Math.Max(_speed - 1, LeastSpeed);
        }
        else if (key.Key == ConsoleKey.C)
        {
            _contacts = !_contacts;
        }
        else if (key.Key == ConsoleKey.R)
        {
            _run = new SceneRun(_scene, _options);
            _hand = new Hand(_run.Simulator);
            _outcomes = [];
            _due = 0.0;
        }
        else
        {
            ReachFor(key.Key);
        }
    }

    private void ReachFor(ConsoleKey key)
    {
        switch (key)
        {
            case ConsoleKey.Tab:
                _hand.ChooseNext();
                break;
            case ConsoleKey.W:
                Throw(0f, 1f);
                break;
            case ConsoleKey.A:
                Throw(-1f, 0f);
                break;
            case ConsoleKey.S:
                Throw(0f, -1f);
                break;
            case ConsoleKey.D:
                Throw(1f, 0f);
                break;
        }
    }

    private void Advance(double elapsed)
    {
        _late = false;
        if (_paused)
        {
            _due = 0.0;
            return;
        }

        double dt = _options.Dt ?? _scene.Dt;

        // A pause of the whole program (a suspended terminal) is not made up for.
        _due += Math.Min(elapsed, 0.25) * Math.Pow(2.0, _speed);
        long start = Stopwatch.GetTimestamp();
        while (_due >= dt)
        {
            Step();
            _due -= dt;
            if ((double)(Stopwatch.GetTimestamp() - start) / Stopwatch.Frequency > StepShare / FramesPerSecond)
            {
                _late = _due >= dt;
                _due = 0.0;
            }
        }
    }

    private void Step()
    {
        _run.Step();
        if (_run.Done == _scene.Steps && _options.KeepsOutcome && !_hand.HasTouched)
        {
            _outcomes = _scene.Check();
        }
    }

    private void Draw(TerminalScreen screen)
    {
        (int width, int height) = screen.Measure();
        _rows.Clear();
        _rows.Add(Headline(width).ToString());
        int picture = height - 3;
        if (picture > 0)
        {
            _canvas.Reset(width, picture);
            _painter.Chosen = _hand.Chosen;
            _painter.Paint(_scene, _run.Simulator, _contacts);
            StringBuilder text = new(width);
            for (int row = 0; row < picture; row++)
            {
                _canvas.AppendRow(text.Clear(), row, _colored);
                _rows.Add(text.ToString());
            }
        }

        if (height >= 2)
        {
            if (height >= 3)
            {
                _rows.Add(Legend(width).ToString());
            }

            _rows.Add(new TextRow(width, _colored)
                .Add(KeyText, Palette.Dim).ToString());
        }

        screen.Show(_rows);
    }

    private TextRow Headline(int width)
    {
        double time = _run.Done * (double)(_options.Dt ?? _scene.Dt);
        string speed = _speed >= 0 ? FormattableString.Invariant($"{1 << _speed}x") : FormattableString.Invariant($"1/{1 << -_speed}x");
        TextRow row = new(width, _colored);
        row.Add(_scene.Title, Palette.Title);
        row.Add(FormattableString.Invariant($"  step {_run.Done}  t {time:0.00} s  speed {speed}"), Palette.Text);
        if (_paused)
        {
            row.Add("  PAUSED", Palette.Title);
        }
        else if (_late)
        {
            row.Add("  slower than real time", Palette.Dim);
        }

        int ok = 0;
        foreach (SceneOutcome outcome in _outcomes)
        {
            ok += outcome.Ok ? 1 : 0;
        }

        if (_outcomes.Count > 0)
        {
            row.Add(FormattableString.Invariant($"  checks {ok}/{_outcomes.Count}"), ok == _outcomes.Count ? Palette.Good : Palette.Bad);
        }

        return row;
    }

    private TextRow Legend(int width) =>
        new TextRow(width, _colored)
            .Add(
                FormattableString.Invariant($"bodies {_run.Simulator.BodyList.Count}  contacts {_run.Simulator.ContactCount}  "),
                Palette.Text)
            .Add("flying ", Palette.Flying)
            .Add("touching ", Palette.Touching)
            .Add("at rest ", Palette.Resting)
            .Add("driven ", Palette.Driven)
            .Add("sensor ", Palette.Sensor)
            .Add("static", Palette.Static);
}
