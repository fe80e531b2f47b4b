using System;
using System.Threading;
using System.Threading.Tasks;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace Farseer.Samples.Terminal;

/// <summary>A terminal on which <c>q</c> means <c>esc</c>, but not within a word that is being searched for.</summary>
internal sealed class LeavingConsole : IAnsiConsole
{
    private readonly IAnsiConsole _inner;

    public LeavingConsole(IAnsiConsole inner)
    {
        _inner = inner;
        Input = new LeavingInput(inner.Input);
    }

    public Profile Profile => _inner.Profile;

    public IAnsiConsoleCursor Cursor => _inner.Cursor;

    public IAnsiConsoleInput Input { get; }

    public IExclusivityMode ExclusivityMode => _inner.ExclusivityMode;

    public RenderPipeline Pipeline => _inner.Pipeline;

    public void Clear(bool home) => _inner.Clear(home);

    public void Write(IRenderable renderable) => _inner.Write(renderable);

    public void WriteAnsi(Action<AnsiWriter> action) => _inner.WriteAnsi(action);

    private sealed class LeavingInput(IAnsiConsoleInput inner) : IAnsiConsoleInput
    {
        private int _typed;

        public bool IsKeyAvailable() => inner.IsKeyAvailable();

        public ConsoleKeyInfo? ReadKey(bool intercept) => Translated(inner.ReadKey(intercept));

        public async Task<ConsoleKeyInfo?> ReadKeyAsync(bool intercept, CancellationToken cancellationToken) =>
            Translated(await inner.ReadKeyAsync(intercept, cancellationToken).ConfigureAwait(false));

        private ConsoleKeyInfo? Translated(ConsoleKeyInfo? key)
        {
            if (key is not ConsoleKeyInfo pressed)
            {
                return null;
            }

            if (pressed.Key == ConsoleKey.Backspace)
            {
                _typed = Math.Max(_typed - 1, 0);
            }
            else if (pressed.Key is ConsoleKey.Enter or ConsoleKey.Escape)
            {
                _typed = 0;
            }
            else if (pressed.Key == ConsoleKey.Q && _typed == 0)
            {
                return new ConsoleKeyInfo('\e', ConsoleKey.Escape, false, false, false);
            }
            else if (!char.IsControl(pressed.KeyChar))
            {
                _typed++;
            }

            return key;
        }
    }
}
