using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using Farseer.Hunt.Calls;

namespace Farseer.Hunt.Running;

/// <summary>What came of a call.</summary>
internal enum Outcome
{
    Skipped,
    Done,
    Refused,
}

/// <summary>Runs a world and looks at all invariants between its steps.</summary>
internal sealed class Machine
{
    /// <summary>
    /// An update of some hundred bodies takes some milliseconds, the first ones some hundred; what takes so long is no matter of a
    /// busy machine.
    /// </summary>
    private const double MostSeconds = 20;

    private readonly Script _script;
    private readonly int? _workers;
    private readonly Random? _random;
    private readonly Observer _observer;
    private readonly Invariants _invariants;
    private readonly Dictionary<int, object> _items = new();
    private readonly List<Exception> _thrown = new();
    private bool _isMuted;
    private int _inHandlers;
    private int _handled;
    private int _call;

    /// <param name="script">The world.</param>
    /// <param name="workers">For all its simulations.</param>
    /// <param name="detours">Before some steps the world is captured, something else is done with it, and it is restored.</param>
    public Machine(Script script, int? workers = null, int? detours = null)
    {
        _random = detours is { } seed ? new Random(seed) : null;
        _script = script;
        _workers = workers;
        _observer = script.Facade.Observe();
        _invariants = new Invariants(script.Profile, _observer);
    }

    public Failure? Failure { get; private set; }

    public int Steps { get; private set; }

    public int Calls { get; private set; }

    /// <summary>The longest step, seconds.</summary>
    public double Longest { get; private set; }

    /// <summary>Of each world after each of its steps.</summary>
    public List<ulong> Hashes { get; } = new();

    /// <summary>Of all events that were told until then.</summary>
    public List<ulong> EventHashes { get; } = new();

    public int Detours => _observer.Detours;

    /// <summary>States are kept with the names of their fields, to look for the first difference.</summary>
    public bool Keeps { get; init; }

    public string? FirstDifference(Machine other) => _observer.FirstDifference(other._observer);

    /// <summary>Of the worlds that are there after the last call.</summary>
    public List<ulong> LastHashes { get; private set; } = new();

    public Dictionary<int, Outcome> Outcomes { get; } = new();

    /// <summary>Worlds, by the numbers of the calls that made them.</summary>
    public IEnumerable<int> Worlds => _items.Where(i => _script.Facade.World.IsInstanceOfType(i.Value)).Select(i => i.Key);

    public void Run()
    {
        foreach (Call call in _script.Calls)
        {
            Perform(call);
            if (Failure is not null)
            {
                return;
            }
        }

        LastHashes = Worlds.Select(w => _observer.Hash(_items[w])).Where(h => h != 0).ToList();
        if (_script.Profile >= Profile.Ordinary)
        {
            FinishCalmly();
        }
    }

    private void FinishCalmly()
    {
        _isMuted = true;
        foreach (object world in _items.Values.Where(_script.Facade.World.IsInstanceOfType).ToList())
        {
            try
            {
                if (_observer.FallOfANewBody(world) is { } wrong)
                {
                    Fail("a new body does not fall", wrong);
                }
            }
            catch (Exception exception)
            {
                Accept(exception);
            }
        }
    }

    private void Perform(Call call)
    {
        Calls++;
        object?[] arguments = new object?[call.Arguments.Count + (call.Member is HandlerMember ? 1 : 0)];
        try
        {
            for (int i = 0; i < call.Arguments.Count; i++)
            {
                arguments[i] = call.Member.Kinds[i].Live(call.Arguments[i], id => _items.GetValueOrDefault(id));
            }
        }
        catch (MissingItemException)
        {
            Outcomes[call.Id] = Outcome.Skipped;
            return;
        }

        int outer = _call;
        _call = call.Id;
        Outcomes[call.Id] = Outcome.Done;
        if (call.Member is StepMember && _inHandlers == 0)
        {
            Step(call, arguments);
        }
        else if (call.Member is ThrowMember)
        {
            ThrowOnPurpose(call, arguments);
        }
        else
        {
            try
            {
                if (call.Member is HandlerMember)
                {
                    var state = new HandlerState(this, call);
                    arguments[^1] = (Func<bool>)state.Raise;
                }

                object? made = call.Member.Invoke(arguments);
                if (call.Made is not null && made is not null)
                {
                    // Some members return what is known already.
                    bool isNew = !_items.Values.Contains(made, ReferenceEqualityComparer.Instance);
                    _items[call.Id] = made;
                    if (isNew)
                    {
                        _observer.Made(made, arguments);
                    }
                }
            }
            catch (Exception exception)
            {
                Outcomes[call.Id] = Outcome.Refused;
                Accept(exception);
            }
        }

        _call = outer;
    }

    private void ThrowOnPurpose(Call call, object?[] arguments)
    {
        try
        {
            call.Member.Invoke(arguments);
        }
        catch (Exception exception)
        {
            _thrown.Add(exception);
            throw;
        }
    }

    private void Step(Call call, object?[] arguments)
    {
        object world = arguments[0]!;
        for (int i = (int)arguments[2]!; i > 0 && Failure is null; i--)
        {
            if (_workers is { } workers)
            {
                _observer.SetWorkers(world, workers);
            }

            if (_random is not null && _random.Next(3) == 0)
            {
                _isMuted = true;
                _observer.Detour(world, _random);
                _isMuted = false;
            }

            int handled = _handled;
            int thrown = _thrown.Count;
            long start = Stopwatch.GetTimestamp();
            try
            {
                call.Member.Invoke(arguments);
            }
            catch (Exception exception)
            {
                Outcomes[call.Id] = Outcome.Refused;
                Accept(exception);
            }

            Steps++;
            double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
            Longest = Math.Max(Longest, seconds);
            if (seconds > MostSeconds)
            {
                Fail("slow step", string.Create(CultureInfo.InvariantCulture, $"{seconds:g3} s"));
            }

            _observer.Stepped(world);
            if (Keeps)
            {
                _observer.Keep(world);
            }

            Hashes.Add(_observer.Hash(world));
            EventHashes.Add(_observer.Events);
            if (Failure is null && _invariants.After(world, (float)arguments[1]!, _items.Values, _handled == handled
                && _thrown.Count == thrown) is { } wrong)
            {
                Fail(wrong.Kind, wrong.Text, wrong.Excess);
            }
        }
    }

    /// <summary>
    /// Refusals are what is documented, and what a handler throws comes out where its event was told; anything else is a failure.
    /// </summary>
    private void Accept(Exception exception)
    {
        if (exception is ArgumentException or InvalidOperationException || _thrown.Contains(exception)
            || (exception is AggregateException all && all.InnerExceptions.All(_thrown.Contains)))
        {
            return;
        }

        string? place = new StackTrace(exception).GetFrames().Select(f => f.GetMethod()).Where(m
            => m?.DeclaringType?.Namespace?.Contains("Hunt", StringComparison.Ordinal) == false)
            .Select(m => m!.DeclaringType!.Name + "." + m.Name).FirstOrDefault(n => !n.StartsWith("RuntimeMethod",
                StringComparison.Ordinal));
        Fail($"{exception.GetType().Name} in {place}", exception.ToString());
    }

    private void Fail(string kind, string text, double excess = 1) => Failure ??= new Failure(kind, text, _call, Steps, excess);

    private sealed class HandlerState(Machine machine, Call call)
    {
        private int _told;

        public bool Raise()
        {
            if (machine._isMuted)
            {
                return true;
            }

            machine._observer.Told((ulong)call.Id);
            _told++;
            if (_told == (int)call.Arguments[1])
            {
                machine._handled++;
                machine._inHandlers++;
                try
                {
                    foreach (Call inner in call.Inner)
                    {
                        machine.Perform(inner);
                    }
                }
                finally
                {
                    machine._inHandlers--;
                }
            }

            int veto = (int)call.Arguments[2];
            machine._handled += veto > 0 ? 1 : 0;
            return veto == 0 || _told % veto != 0;
        }
    }

    public static string Describe(Failure failure) =>
        string.Create(CultureInfo.InvariantCulture, $"{failure.Kind} at call {failure.Call}, after {failure.Step} steps: {failure.Text}");
}
