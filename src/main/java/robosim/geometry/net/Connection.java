package robosim.geometry.net;

import java.io.IOException;
import java.net.Socket;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.DistanceBundle;
import robosim.geometry.protocol.Gate;
import robosim.geometry.protocol.MessageChannel;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.Text;

/** One socket and its session, whoever dialled. Whatever comes over it ends here. */
final class Connection implements Runnable {
    private static final System.Logger LOG = System.getLogger(Connection.class.getPackageName());

    private final Socket socket;
    private final String name;
    private final NetOptions options;
    private volatile boolean stopping;

    Connection(Socket socket, String name, NetOptions options) {
        this.socket = socket;
        this.name = name;
        this.options = options;
    }

    /** Answers until the peer ends, errs or is told to stop; then the socket is closed. Nothing is thrown. */
    @Override
    public void run() {
        LOG.log(System.Logger.Level.DEBUG, name + ": open");
        try {
            converse();
            LOG.log(System.Logger.Level.DEBUG, name + ": closed, at its end");
        } catch (ProtocolException e) {
            closed(String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            closed("the answer could not be sent: " + e.getMessage(), e);
        } catch (RuntimeException | Error e) {
            LOG.log(System.Logger.Level.ERROR, name + ": closed, after an error of the module itself", e);
        } finally {
            abort();
        }
    }

    private void converse() throws IOException {
        socket.setTcpNoDelay(true); // answers are small and waited for
        socket.setKeepAlive(true); // an idle peer that is gone is noticed in the end
        PacedInput in = new PacedInput(socket, options.stallTime(), options.messageTime());
        MessageChannel channel = new MessageChannel(in, socket.getOutputStream(), options.translator(), in, Gate.OPEN);
        Session session = new Session(options.session(), options.listeners().apply(name), name);
        for (Bundle request = channel.read(); request != null; request = channel.read()) {
            Reply reply = reply(session, request);
            if (reply != null) {
                channel.write(reply);
            }
        }
    }

    private static @Nullable Reply reply(Session session, Bundle request) throws ProtocolException {
        if (request instanceof DistanceBundle) {
            throw new ProtocolException("a request must be an InitBundle, a MoveBundle or a SonarRequestBundle (got: "
                    + request.getClass().getSimpleName() + ")");
        }
        return session.reply(request);
    }

    private void closed(String reason, Exception e) {
        System.Logger.Level level = stopping ? System.Logger.Level.DEBUG : System.Logger.Level.WARNING;
        LOG.log(level, name + ": closed, " + Text.line(reason));
        LOG.log(System.Logger.Level.DEBUG, name + ": in detail", e);
    }

    /** No more is read; what has been read is still answered. */
    void stop() {
        stopping = true;
        try {
            socket.shutdownInput();
        } catch (IOException e) {
            abort(); // not connected, or closed already
        }
    }

    /** Ends at once. */
    void abort() {
        stopping = true;
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, name + ": the socket could not be closed", e);
        }
    }
}
