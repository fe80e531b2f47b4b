using System;
using System.Collections.Generic;
using System.Linq;

namespace Farseer.Hunt.Calls;

/// <summary>Reads a world out of choices, without running it: a call may refer to what an earlier one will have made.</summary>
internal sealed class Decoder
{
    private const int MostCalls = 4000;

    private readonly Facade _facade;
    private readonly List<(int Id, Type Type)> _made = new();
    private List<Call> _calls = new();
    private int _next;
    private bool _isInHandler;

    private Decoder(Facade facade, Choices choices, Profile? profile)
    {
        _facade = facade;
        Choices = choices;
        Profile = profile ?? (choices.Below(16) switch { 0 or 1 => Profile.Free, 2 or 3 or 4 => Profile.Passive, < 11 => Profile.Ordinary,
            _ => Profile.Extreme });
    }

    public Choices Choices { get; }

    public Profile Profile { get; }

    public static Script Read(Facade facade, Choices choices, Profile? profile = null)
    {
        var decoder = new Decoder(facade, choices, profile);
        facade.Open(decoder);
        while (!choices.AreSpent && decoder._next < MostCalls)
        {
            decoder.Go();
        }

        return new Script(facade, decoder.Profile, decoder._calls);
    }

    /// <summary>An item that was made, more often one of the last.</summary>
    public int? Pick(Type type)
    {
        List<int> found = _made.Where(m => type.IsAssignableFrom(m.Type)).Select(m => m.Id).ToList();
        return found.Count == 0 ? null
            : Choices.OneIn(4) ? found[found.Count - 1 - Choices.Below(Math.Min(4, found.Count))]
            : found[Choices.Below(found.Count)];
    }

    public bool Has(Type type) => _made.Any(m => type.IsAssignableFrom(m.Type));

    /// <summary>A call with these arguments; what is left out is drawn.</summary>
    /// <returns>Its number, or −1 if there was nothing to call it with.</returns>
    public int Emit(string key, params object?[] arguments) => Emit(_facade.Find(key), arguments);

    private int Emit(Member member, object?[] arguments)
    {
        object?[] values = member.Kinds.Select((kind, i) => i < arguments.Length && arguments[i] is { } given ? given
            : kind.Draw(this)).ToArray();
        if (values.Contains(null))
        {
            return -1;
        }

        int id = _next++;
        IReadOnlyList<Call> inner = member is HandlerMember ? InHandler() : Array.Empty<Call>();
        Type? made = member.ResultOf?.Invoke(values!, i => _made.Find(m => m.Id == i).Type) ?? member.Result;
        if (made is not null)
        {
            _made.Add((id, made));
        }

        _calls.Add(new Call(id, member, values!, inner, made));
        return id;
    }

    private List<Call> InHandler()
    {
        List<Call> outer = _calls;
        _calls = new List<Call>();
        _isInHandler = true;
        for (int i = Choices.Below(3); i >= 0; i--)
        {
            if (Choices.OneIn(8))
            {
                Emit(_facade.Throw, Array.Empty<object?>());
                break;
            }

            Anything();
        }

        _isInHandler = false;
        List<Call> inner = _calls;
        _calls = outer;
        return inner;
    }

    private void Go()
    {
        if (Profile < Profile.Ordinary)
        {
            // Nobody touches it: steps, and members that only look.
            if (Choices.OneIn(4))
            {
                Emit(_facade.Looks[Choices.Below(_facade.Looks.Count)], Array.Empty<object?>());
            }

            Emit(_facade.Step, Array.Empty<object?>());
        }
        else if (Choices.OneIn(3))
        {
            Emit(_facade.Step, Array.Empty<object?>());
        }
        else
        {
            Anything();
        }
    }

    private void Anything()
    {
        if (Choices.OneIn(4))
        {
            _facade.Compose(this);
            return;
        }

        // Some members have nothing to work on yet.
        for (int i = 0; i < 8; i++)
        {
            Member member = _facade.Members[Choices.Below(_facade.Members.Count)];
            if (!(member is HandlerMember or ThrowMember && (_isInHandler || member is ThrowMember)) && Emit(member,
                Array.Empty<object?>()) >= 0)
            {
                return;
            }
        }
    }
}
