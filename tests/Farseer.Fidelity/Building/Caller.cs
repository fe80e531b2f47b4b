using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Building;

/// <summary>Chooses and calls the overload that the arguments of a scene file fit.</summary>
public sealed class Caller
{
    private readonly ValueReader _values;

    public Caller(ValueReader values) => _values = values;

    /// <summary>
    /// Calls a factory method with arguments by parameter name. <paramref name="known"/> are arguments that are objects already.
    /// </summary>
    public object Make(object factory, string method, JsonElement args, IReadOnlyDictionary<string, object> known)
    {
        Dictionary<string, JsonElement> given = args.ValueKind == JsonValueKind.Object
            ? args.EnumerateObject().ToDictionary(p => p.Name, p => p.Value, StringComparer.OrdinalIgnoreCase)
            : [];
        string wanted = factory.GetType().Name + "." + method + "(" + string.Join(", ", given.Keys.Concat(known.Keys)) + ")";
        foreach (MethodInfo candidate in Facade.Methods(factory.GetType(), method, isStatic: false))
        {
            ParameterInfo[] parameters = candidate.GetParameters();
            bool namesFit = given.Keys.Concat(known.Keys).All(n => parameters.Any(p => SameName(p, n)))
                && parameters.All(p => p.IsOptional || given.ContainsKey(p.Name!) || known.ContainsKey(p.Name!));
            if (namesFit && TryFill(parameters, given, known, out object?[] values))
            {
                return Facade.Invoke(candidate, factory, values) ?? throw new InvalidOperationException(wanted + " returned null.");
            }
        }

        throw new MissingPartException(wanted);
    }

    /// <summary>
    /// Calls a method with positional arguments. Parameters beyond them must be handed out by the
    /// method (<c>out</c>, or a list passed by reference); the result is then those values.
    /// </summary>
    public CallResult Call(Type type, object? target, string method, IReadOnlyList<JsonElement> args)
    {
        IEnumerable<MethodInfo> candidates = Facade.Methods(type, method, target is null)
            .OrderBy(m => m.GetParameters().Count(p => p.ParameterType.IsByRef));
        foreach (MethodInfo candidate in candidates)
        {
            if (TryFill(candidate.GetParameters(), args, out object?[] values, out List<int> handedOut))
            {
                object? returned = Facade.Invoke(candidate, target, values);
                return new CallResult(returned, candidate.ReturnType == typeof(void), handedOut.Select(i => values[i]).ToList());
            }
        }

        throw new MissingPartException(type.Name + "." + method + "(" + string.Join(", ", args) + ")");
    }

    private static bool SameName(ParameterInfo parameter, string name) =>
        string.Equals(parameter.Name, name, StringComparison.OrdinalIgnoreCase);

    private bool TryFill(
        ParameterInfo[] parameters, Dictionary<string, JsonElement> given, IReadOnlyDictionary<string, object> known, out object?[] values)
    {
        values = new object?[parameters.Length];
        for (int i = 0; i < parameters.Length; i++)
        {
            ParameterInfo parameter = parameters[i];
            if (known.TryGetValue(parameter.Name!, out object? value))
            {
                values[i] = value;
            }
            else if (!given.TryGetValue(parameter.Name!, out JsonElement json))
            {
                values[i] = parameter.DefaultValue;
            }
            else if (!_values.TryRead(json, parameter.ParameterType, out values[i]))
            {
                return false;
            }
        }

        return true;
    }

    private bool TryFill(ParameterInfo[] parameters, IReadOnlyList<JsonElement> args, out object?[] values, out List<int> handedOut)
    {
        values = new object?[parameters.Length];
        handedOut = [];
        int used = 0;
        for (int i = 0; i < parameters.Length; i++)
        {
            ParameterInfo parameter = parameters[i];
            if (parameter.IsOut)
            {
                handedOut.Add(i);
            }
            else if (used < args.Count)
            {
                if (!_values.TryRead(args[used++], parameter.ParameterType, out values[i]))
                {
                    return false;
                }
            }
            else if (parameter.ParameterType.IsByRef)
            {
                values[i] = Activator.CreateInstance(parameter.ParameterType.GetElementType()!);
                handedOut.Add(i);
            }
            else
            {
                return false;
            }
        }

        return used == args.Count;
    }
}

/// <summary>What a call gave: its return value and what it handed out through its parameters.</summary>
public sealed record CallResult(object? Returned, bool IsVoid, IReadOnlyList<object?> HandedOut);
